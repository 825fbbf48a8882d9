// judgement
