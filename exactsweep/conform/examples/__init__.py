"""Small programs that speak the protocol of `exactsweep conform`, to begin with."""
