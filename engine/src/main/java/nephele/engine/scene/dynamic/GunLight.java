package nephele.engine.scene.dynamic;

import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** The light of the portal gun's own lamps on it; the exact twin of {@code gun-light.glsl}. Positions are the gun's own. */
public final class GunLight {
    private static final double HOOP_HALF_WIDTH_METRES = 0.055;
    private static final double HOOP_HALF_HEIGHT_METRES = 0.075;
    private static final Vec3 CHAMBER = new Vec3(0, GunMesh.AXIS_METRES, GunMesh.CHAMBER_METRES);
    private static final Vec3 HOOP = new Vec3(0, 0.062, GunMesh.MUZZLE_METRES);
    private static final double HALF_CHAMBER_METRES = 0.03;
    private static final double LAMP_REACH_METRES = 0.03;
    private static final double FLASH_REACH_METRES = 0.11;
    /** Share of a lamp's light that arrives at right angles: lamps are no points. */
    private static final double WRAPPED = 0.35;

    private GunLight() {}

    /** Returns the share of the lamps' light at a place with this unit normal. */
    public static double ofLamps(Vector3dc place, Vector3dc normal) {
        double along =
                Math.max(CHAMBER.z() - HALF_CHAMBER_METRES, Math.min(CHAMBER.z() + HALF_CHAMBER_METRES, place.z()));
        Vector3d chamber = new Vector3d(CHAMBER.x(), CHAMBER.y(), along);
        Vector3d out =
                new Vector3d(place.x() / HOOP_HALF_WIDTH_METRES, (place.y() - HOOP.y()) / HOOP_HALF_HEIGHT_METRES, 0);
        out.div(Math.max(out.length(), 1e-5));
        Vector3d hoop = HOOP.toVector().add(HOOP_HALF_WIDTH_METRES * out.x, HOOP_HALF_HEIGHT_METRES * out.y, 0);
        return light(place, normal, chamber, LAMP_REACH_METRES) + light(place, normal, hoop, LAMP_REACH_METRES);
    }

    /** Returns the share of the light of a shot's flash. */
    public static double ofFlash(Vector3dc place, Vector3dc normal) {
        return light(place, normal, HOOP.toVector(), FLASH_REACH_METRES);
    }

    private static double light(Vector3dc place, Vector3dc normal, Vector3dc lamp, double reach) {
        Vector3d towards = new Vector3d(lamp).sub(place);
        double square = towards.lengthSquared();
        double facing = normal.dot(towards) / Math.sqrt(Math.max(square, 1e-10));
        return Math.max(0, facing * (1 - WRAPPED) + WRAPPED) * reach * reach / (square + reach * reach);
    }
}
