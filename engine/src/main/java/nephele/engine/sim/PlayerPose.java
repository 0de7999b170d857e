package nephele.engine.sim;

import nephele.engine.math.Vec3;

/** Where the player's eye is and looks between two ticks: what rendering needs of the simulation. */
public record PlayerPose(Vec3 eye, double yawRadians, double pitchRadians) {
    /** @param share of the tick that has passed, 0 to 1; yaw turns by the shorter way */
    public static PlayerPose between(SimState before, SimState after, double share) {
        PlayerState a = before.player();
        PlayerState b = after.player();
        Vec3 eye = new Vec3(
                mix(a.feet().x(), b.feet().x(), share),
                mix(a.feet().y() + a.eyeMetres(), b.feet().y() + b.eyeMetres(), share),
                mix(a.feet().z(), b.feet().z(), share));
        double yaw = a.heading().yawRadians() + share * a.heading().yawRadiansTo(b.heading());
        double pitch = mix(a.heading().pitchRadians(), b.heading().pitchRadians(), share);
        return new PlayerPose(eye, wrapped(yaw), pitch);
    }

    private static double mix(double a, double b, double share) {
        return a + (b - a) * share;
    }

    private static double wrapped(double yaw) {
        if (yaw < -Math.PI) {
            return yaw + 2 * Math.PI;
        }
        return yaw < Math.PI ? yaw : yaw - 2 * Math.PI;
    }
}
