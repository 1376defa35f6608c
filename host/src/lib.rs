//! carom host
