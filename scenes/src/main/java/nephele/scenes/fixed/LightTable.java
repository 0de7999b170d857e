package nephele.scenes.fixed;

import nephele.engine.math.Vec3;
import nephele.scenes.xml.XmlLight;
import org.joml.Matrix4dc;
import org.joml.Vector3d;

/** Lights in the layout of the shaders, in world coordinates. */
final class LightTable {
    static final int FLOATS = 12;

    /** Smaller than any cosine. */
    private static final float ALL_AROUND = -2;

    private final float[] packed;
    private final Vector3d moved = new Vector3d();

    LightTable(int lights) {
        packed = new float[FLOATS * lights];
    }

    float[] packed() {
        return packed;
    }

    /** @param next the next light of the chain, −1 for its end */
    void put(int number, XmlLight light, Matrix4dc worldFromLight, int next) {
        int at = FLOATS * number;
        packed[at + 7] = ALL_AROUND;
        packed[at + 9] = next;
        if (light instanceof XmlLight.Directional directional) {
            direction(at, directional.towards(), worldFromLight);
            packed[at + 3] = 0;
        } else if (light instanceof XmlLight.Point point) {
            position(at, point.position(), worldFromLight);
        } else if (light instanceof XmlLight.Spot spot) {
            position(at, spot.position(), worldFromLight);
            direction(at + 4, spot.direction(), worldFromLight);
            packed[at + 7] =
                    spot.cutoffDegrees() >= 180 ? ALL_AROUND : (float) Math.cos(Math.toRadians(spot.cutoffDegrees()));
            packed[at + 8] = (float) spot.exponent();
        }
    }

    private void position(int at, Vec3 p, Matrix4dc worldFromLight) {
        Vector3d v = worldFromLight.transformPosition(moved.set(p.x(), p.y(), p.z()));
        packed[at + 3] = put(at, v) ? 1 : 0;
    }

    private void direction(int at, Vec3 d, Matrix4dc worldFromLight) {
        Vector3d v = worldFromLight.transformDirection(moved.set(d.x(), d.y(), d.z()));
        double length = v.length();
        put(at, length > 0 ? v.div(length) : v);
    }

    /** Returns false if transform steps overflow; such a light has a direction of zero length and lights nothing. */
    private boolean put(int at, Vector3d v) {
        boolean finite = Math.abs(v.x) + Math.abs(v.y) + Math.abs(v.z) < Float.MAX_VALUE;
        packed[at] = finite ? (float) v.x : 0;
        packed[at + 1] = finite ? (float) v.y : 0;
        packed[at + 2] = finite ? (float) v.z : 0;
        return finite;
    }
}
