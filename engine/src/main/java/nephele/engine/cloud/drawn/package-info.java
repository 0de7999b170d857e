/**
 * The clouds of a level as every technique draws them: {@link nephele.engine.cloud.drawn.DrawnCloud}, sampled once and
 * lit by the sun of the hour.
 */
package nephele.engine.cloud.drawn;
