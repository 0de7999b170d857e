/**
 * Sheets of cloud made of octaves of noise that change with time: the twin of {@code cloud-octaves.glsl}, and what is sampled
 * for their light.
 */
package nephele.engine.cloud.octave;
