// duel
