package nephele.scenes.xml;

import java.util.List;
import nephele.engine.math.Vec3;
import nephele.scenes.xml.XmlScene.Eye;
import nephele.scenes.xml.XmlScene.Window;
import org.joml.Vector3d;

/** Reads the camera of a scene. */
final class EyeReader {
    static final Window SCENE_WINDOW = new Window(800, 600);
    static final Eye SCENE_EYE = new Eye(Vec3.ZERO, new Vec3(0, 0, 1), new Vec3(0, 1, 0), 45, 1, 1000);
    static final Window WORLD_WINDOW = new Window(512, 512);
    static final Eye WORLD_EYE = new Eye(new Vec3(5, 5, 5), Vec3.ZERO, new Vec3(0, 1, 0), 60, 1, 1000);

    private static final int MOST_PIXELS = 16_384;
    private static final double LEAST_NEAR = 1e-3;
    private static final double LEAST_DEPTH = 1 + 1e-3;

    /** Sine below which two directions define no up. */
    private static final double PARALLEL = 1e-6;

    private final SceneWarnings warnings;

    EyeReader(SceneWarnings warnings) {
        this.warnings = warnings;
    }

    Window window(XmlElement world) {
        XmlElement element = only(world, "window");
        if (element == null) {
            return WORLD_WINDOW;
        }
        ElementValues values = new ElementValues(element, warnings);
        return new Window((int) values.number("width", WORLD_WINDOW.width(), 1, MOST_PIXELS), (int)
                values.number("height", WORLD_WINDOW.height(), 1, MOST_PIXELS));
    }

    /** Returns a valid camera: it has a direction, an up that is not parallel to it, and ordered depths. */
    Eye eye(XmlElement world) {
        XmlElement camera = only(world, "camera");
        if (camera == null) {
            return WORLD_EYE;
        }
        Vec3 position = vector(camera, "position", WORLD_EYE.position());
        Vec3 lookAt = vector(camera, "lookAt", WORLD_EYE.lookAt());
        Vector3d ahead = lookAt.toVector().sub(position.toVector());
        if (!(ahead.length() > 0)) {
            new ElementValues(camera, warnings).warn("it looks at where it stands: taken as looking along -z");
            ahead.set(0, 0, -1);
            lookAt = new Vec3(position.x(), position.y(), position.z() - 1);
        }
        Vec3 up = upright(camera, vector(camera, "up", WORLD_EYE.up()), ahead);
        return projected(only(camera, "projection"), position, lookAt, up);
    }

    private Vec3 upright(XmlElement camera, Vec3 up, Vector3d ahead) {
        Vector3d wanted = up.toVector();
        double sine = wanted.cross(ahead, new Vector3d()).length() / (wanted.length() * ahead.length());
        if (sine > PARALLEL) {
            return up;
        }
        boolean steep = Math.abs(ahead.y) > ahead.length() / 2;
        Vec3 other = steep ? new Vec3(0, 0, -1) : new Vec3(0, 1, 0);
        new ElementValues(camera, warnings)
                .warn("its up is no direction or along its sight: taken as " + (steep ? "0 0 -1" : "0 1 0"));
        return other;
    }

    private Eye projected(XmlElement element, Vec3 position, Vec3 lookAt, Vec3 up) {
        if (element == null) {
            return new Eye(position, lookAt, up, WORLD_EYE.fovDegrees(), WORLD_EYE.near(), WORLD_EYE.far());
        }
        ElementValues values = new ElementValues(element, warnings);
        double fov = values.number("fov", WORLD_EYE.fovDegrees(), 1, 170);
        double near = values.number("near", WORLD_EYE.near(), LEAST_NEAR, 1e8);
        double far = values.number("far", WORLD_EYE.far());
        if (far < near * LEAST_DEPTH) {
            values.warn("far is not beyond near: taken as 1000 times near");
            far = 1000 * near;
        }
        return new Eye(position, lookAt, up, fov, near, far);
    }

    private Vec3 vector(XmlElement camera, String name, Vec3 absent) {
        XmlElement element = only(camera, name);
        return element == null ? absent : new ElementValues(element, warnings).vector("x", "y", "z", 0);
    }

    private XmlElement only(XmlElement parent, String name) {
        List<XmlElement> found = parent.children(name);
        if (found.size() > 1) {
            new ElementValues(found.get(1), warnings).warn("it is there twice: the first counts");
        }
        return found.isEmpty() ? null : found.get(0);
    }
}
