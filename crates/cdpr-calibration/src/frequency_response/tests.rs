//! Frequency responses of machines that are simulated without the library, against closed forms.

mod coverage;
mod derivatives;
mod doubts;
mod machine;
mod orders;
mod powertrain;
