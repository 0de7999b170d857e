/**
 * Techniques of clouds against the path tracer: {@link nephele.lab.technique.SeenSky} is a sky seen from a place, {@link
 * nephele.lab.technique.TableMaker} makes the table from which technique auto chooses, {@link nephele.lab.technique.TracedSkies}
 * keeps what was traced.
 */
package nephele.lab.technique;
