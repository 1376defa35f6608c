//! What do two grains do, by the method the page chose? Reads an impact; writes its outcome, from table or integral.

use crate::integrate;
use carom::Error;
use carom::law::ForceLaw;
use carom::law::embedded::{
    read::{Law, Table},
    standard,
};
use carom::law::{
    Answer, Central, ContactForce, HardSphere, Impact, LinearDashpot, Outside, Response, Rule,
    Soft, Viscoelastic,
};
use core::sync::atomic::{AtomicU64, Ordering};

/// How often a contact was integrated because it lies outside its law's table.
pub static INTEGRATED: AtomicU64 = AtomicU64::new(0);

/// Force laws, and none.
#[derive(Clone, Copy)]
pub enum Material {
    /// Hard spheres with this coefficient of restitution.
    Hard(f64),
    /// Linear spring-dashpot.
    Linear(LinearDashpot<f64>),
    /// Viscoelastic spheres.
    Viscoelastic(Viscoelastic<f64>),
}

/// The rule of every world of this module: a material, a method, and what to do outside the table.
#[derive(Clone, Copy)]
pub struct ChosenRule {
    /// What grains are made of.
    pub material: Material,
    /// eMD* (contacts last and turn) or eMD (they are instantaneous).
    pub lasting: bool,
    /// Outside the table; none is to integrate the contact.
    pub outside: Option<Outside>,
}

impl Rule<f64> for ChosenRule {
    fn collide(&self, impact: &Impact<f64>) -> Answer<f64> {
        match self.material {
            Material::Hard(restitution) => HardSphere { restitution }.collide(impact),
            Material::Linear(law) => self.soft(law, &standard::LINEAR_DASHPOT, impact),
            Material::Viscoelastic(law) => self.soft(law, &standard::VISCOELASTIC, impact),
        }
    }

    fn force(&self, impact: &Impact<f64>, overlap: f64) -> Option<ContactForce<f64>> {
        match self.material {
            Material::Linear(law) if self.lasting => Some(law.force(impact, overlap)),
            Material::Viscoelastic(law) if self.lasting => Some(law.force(impact, overlap)),
            _ => None,
        }
    }

    fn contact_time(&self, impact: &Impact<f64>, overlap: f64) -> Option<f64> {
        match self.material {
            Material::Linear(law) if self.lasting => Some(law.contact_time(impact, overlap)),
            Material::Viscoelastic(law) if self.lasting => Some(law.contact_time(impact, overlap)),
            _ => None,
        }
    }

    fn check(&self) -> Result<(), Error> {
        match self.material {
            Material::Hard(restitution) => HardSphere { restitution }.check(),
            Material::Linear(law) => law.check(),
            Material::Viscoelastic(law) => law.check(),
        }
    }
}

impl ChosenRule {
    fn soft<L: ForceLaw<f64> + Copy>(
        &self,
        law: L,
        table: &'static Table<f32>,
        impact: &Impact<f64>,
    ) -> Answer<f64> {
        let table = Soft::with_table(law, table, self.outside.unwrap_or(Outside::Reject));
        let rule = TableOrIntegrated { law, table, integrate: self.outside.is_none() };
        if self.lasting { rule.collide(impact) } else { Central(rule).collide(impact) }
    }
}

/// The table inside its domain, the contact equation integrated outside.
struct TableOrIntegrated<L> {
    law: L,
    table: Soft<L>,
    integrate: bool,
}

impl<L: ForceLaw<f64>> Rule<f64> for TableOrIntegrated<L> {
    fn collide(&self, impact: &Impact<f64>) -> Answer<f64> {
        let answer = self.table.collide(impact);
        if !(self.integrate && matches!(answer.response, Response::Refused { .. })) {
            return answer;
        }
        INTEGRATED.fetch_add(1, Ordering::Relaxed);
        let scales = self.law.scales(impact);
        let scaled = integrate::contact(L::LAW == Law::LinearDashpot, &impact.groups(&scales));
        Answer::exact(Response::Lasting(scales.outcome(&scaled)))
    }
}
