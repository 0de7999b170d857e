/**
 * Light in clouds without bias, by random walks in double precision: {@link
 * nephele.engine.reference.volume.VolumeTracer}. It shares only the fields and phase functions with what is drawn.
 */
package nephele.engine.reference.volume;
