/**
 * Techniques of clouds against the path tracer: {@link nephele.lab.technique.SkyView} is a sky seen from a place, {@link
 * nephele.lab.technique.TableMaker} makes the table from which technique auto chooses, {@link nephele.lab.technique.TracedSkies}
 * keeps traced pictures, {@link nephele.lab.technique.CloudPages} writes a page for teachers about each technique.
 */
package nephele.lab.technique;
