/**
 * Particles of emitters: the state of each is a function of seed, index and time, so no frame depends on an earlier one.
 * {@link nephele.engine.particle.LevelParticles} evaluates those of a level, {@link
 * nephele.engine.particle.BackToFront} orders them for an eye.
 */
package nephele.engine.particle;
