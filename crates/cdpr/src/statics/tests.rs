//! Derivatives against dual numbers and finite differences, and the laws of statics.
