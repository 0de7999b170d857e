package nephele.lab.trade.subject;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import nephele.engine.asset.Picture;
import nephele.engine.model.Mesh;
import nephele.engine.model.shape.GeneratedName;
import nephele.scenes.fixed.SceneFiles;
import nephele.scenes.xml.XmlModel;
import nephele.scenes.xml.XmlScene;
import nephele.scenes.xml.XmlSceneFile;

/**
 * A teapot and three primitives on a floor under two lights, the scene in which shading and tessellation are judged.
 */
final class StillLife {
    private static final String AROUND =
            """
            <world>
              <camera>
                <position x="0" y="3.2" z="6.4"/> <lookAt x="0" y="0.55" z="0"/> <up x="0" y="1" z="0"/>
                <projection fov="36" near="0.5" far="50"/>
              </camera>
              <lights>
                <light type="point" posx="3.5" posy="4" posz="4"/>
                <light type="directional" dirx="-0.6" diry="0.5" dirz="0.25"/>
              </lights>
              <group>%s</group>
            </world>
            """;

    /** Position, size and tilt about x, in degrees. */
    private static final String TRANSFORM =
            """
            <transform>
              <translate x="%1$s" y="%2$s" z="%3$s"/><scale x="%4$s" y="%4$s" z="%4$s"/>
              <rotate angle="%5$s" x="1" y="0" z="0"/>
            </transform>
            """;

    /** Red, green, blue and highlight from 0 to 255 each, and shininess. */
    private static final String COLOUR =
            """
            <color>
              <diffuse R="%1$d" G="%2$d" B="%3$d"/><ambient R="24" G="24" B="30"/>
              <specular R="%4$d" G="%4$d" B="%4$d"/><emissive R="0" G="0" B="0"/><shininess value="%5$d"/>
            </color>
            """;

    private StillLife() {}

    /** @param slices of round models; the teapot's patches are cut into a quarter as many parts */
    static XmlScene of(int slices) {
        int parts = Math.max(1, slices / 4);
        String cut = "_" + slices + "_" + slices;
        return read(floor(parts)
                + model("sphere_1" + cut, at(-2.1, 0.8, 0.3, 0.8), colour(60, 70, 110, 190))
                + model("torus_0.7_0.32" + cut, at(2.2, 0.32, 0.6, 1), colour(40, 190, 80, 50))
                + model("cone_0.8_2.2" + cut, at(1.4, 0, -1.5, 1), colour(20, 90, 160, 80))
                + model("bezier_" + parts, at(0, 0, 0, 0.42, -90), colour(90, 200, 160, 70)));
    }

    /** Returns a scene of three cones: slender, as wide as high, flat. */
    static XmlScene cones(int slices) {
        String cut = "_" + slices + "_16";
        return read(floor(1)
                + model("cone_0.6_2.4" + cut, at(-2.2, 0, 0, 1), colour(40, 190, 80, 50))
                + model("cone_1_2" + cut, at(0, 0, 0, 1), colour(40, 90, 160, 80))
                + model("cone_1.2_0.8" + cut, at(2.5, 0, 0, 1), colour(40, 70, 110, 190)));
    }

    private static String floor(int divisions) {
        return model("plane_9_" + divisions, at(0, 0, 0, 1), colour(0, 120, 115, 110));
    }

    private static String at(double x, double y, double z, double scale) {
        return at(x, y, z, scale, 0);
    }

    private static String at(double x, double y, double z, double scale, double tiltDegrees) {
        return String.format(Locale.ROOT, TRANSFORM, x, y, z, scale, tiltDegrees);
    }

    private static String colour(int shininess, int red, int green, int blue) {
        return String.format(Locale.ROOT, COLOUR, red, green, blue, shininess > 0 ? 200 : 0, shininess);
    }

    private static String model(String shape, String transform, String colour) {
        return "<group>" + transform + "<models><model file=\"" + shape + ".3d\">" + colour
                + "</model></models></group>";
    }

    private static XmlScene read(String models) {
        String text = String.format(Locale.ROOT, AROUND, models);
        return XmlSceneFile.read("still-life.xml", text.getBytes(StandardCharsets.UTF_8));
    }

    /** Generates the mesh of each name once. */
    static final class Generated implements SceneFiles {
        private final Map<String, Mesh> meshes = new HashMap<>();

        @Override
        public Mesh mesh(XmlModel model) {
            return meshes.computeIfAbsent(model.file(), name -> GeneratedName.shape(name, neighbour -> null)
                    .orElseThrow()
                    .mesh());
        }

        @Override
        public Picture picture(XmlModel model) {
            return null;
        }
    }
}
