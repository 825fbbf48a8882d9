// lut_usage
