package nephele.scenes.xml;

import nephele.engine.math.Vec3;

/**
 * A mesh with its appearance.
 *
 * @param line its line; the first is 1
 * @param file file of the mesh, relative to the scene's
 * @param texture {@code null} for none
 */
public record XmlModel(int line, String file, String texture, Colours colours) {
    /** Material colours of fixed-function OpenGL: red, green and blue, 0–1. @param shininess 0–128 */
    public record Colours(Vec3 diffuse, Vec3 ambient, Vec3 specular, Vec3 emissive, double shininess) {}
}
