package nephele.scenes.xml;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;
import nephele.scenes.xml.XmlScene.XmlWarning;
import org.joml.Matrix4dc;
import org.joml.Vector3d;

/**
 * Converts lights without falloff to lights with falloff: each has its old intensity at the mean distance of the
 * models, where a white face turned to it is white.
 */
final class DraftLights {
    private static final int MOST_LIGHTS = 1000;

    /**
     * Greatest number of lights with shadows: each has six depth pictures, whose cost is visible before their effect
     * is.
     */
    private static final int MOST_SHADOWS = 8;

    private static final double LEAST_DISTANCE_METRES = 1;
    private static final double FARTHEST_METRES = 1e4;
    private static final double LEAST_RANGE_METRES = 20;
    private static final double LEAST_CUTOFF_DEGREES = 0.1;

    private final DraftGround ground;
    private final List<Light> lights = new ArrayList<>();
    private Sun sun;
    private int leftOut;

    private DraftLights(DraftGround ground) {
        this.ground = ground;
    }

    static DraftLights of(PosedScene posed, DraftGround ground, XmlScene scene, List<XmlWarning> warnings) {
        int line = scene.root().line();
        DraftLights lights = new DraftLights(ground);
        for (int i = 0; i < posed.lightCount(); i++) {
            lights.add(posed.light(i), posed.worldFromLight(i));
        }
        if (lights.leftOut > 0) {
            warnings.add(new XmlWarning(
                    line,
                    "lights left out: " + lights.leftOut + "; a level has one sun and " + MOST_LIGHTS
                            + " punctual lights"));
        }
        if (posed.lightCount() == 0) {
            warnings.add(new XmlWarning(line, "it has no light: a sun is added"));
            lights.sun = new Sun(new Vec3(0.4, 0.8, 0.5), grey(2.5), true);
        }
        return lights;
    }

    private void add(XmlLight light, Matrix4dc worldFromLight) {
        if (light instanceof XmlLight.Directional directional) {
            Vec3 towards = direction(directional.towards(), worldFromLight);
            if (sun == null && towards != null) {
                sun = new Sun(towards, grey(Math.PI), true);
            } else {
                leftOut++;
            }
            return;
        }
        Vec3 position = light instanceof XmlLight.Point point
                ? position(point.position(), worldFromLight)
                : position(((XmlLight.Spot) light).position(), worldFromLight);
        if (lights.size() == MOST_LIGHTS || position == null) {
            leftOut++;
        } else {
            lights.add(light(light, position, worldFromLight));
        }
    }

    private Light light(XmlLight light, Vec3 position, Matrix4dc worldFromLight) {
        String id = "light-" + (lights.size() + 1);
        double distance = Math.max(LEAST_DISTANCE_METRES, ground.meanDistanceMetres(position));
        Vec3 intensity = grey(Math.PI * Math.min(distance, FARTHEST_METRES) * Math.min(distance, FARTHEST_METRES));
        double range = Math.min(1e7, Math.max(LEAST_RANGE_METRES, 2 * ground.reachMetres(position)));
        boolean shadow = lights.size() < MOST_SHADOWS && !ground.isEnclosed(position);
        Vec3 axis = light instanceof XmlLight.Spot spot ? direction(spot.direction(), worldFromLight) : null;
        if (!(light instanceof XmlLight.Spot cone) || cone.cutoffDegrees() > 90 || axis == null) {
            return new Light.Point(id, position, intensity, range, shadow);
        }
        double outer = Math.max(LEAST_CUTOFF_DEGREES, cone.cutoffDegrees());
        double inner = Math.min(outer, halfPowerDegrees(cone.exponent()) / 2);
        return new Light.Spot(id, position, axis, intensity, range, inner, outer, shadow);
    }

    /** Returns the angle where cosᵉ is ½; 180° for e = 0. */
    private static double halfPowerDegrees(double exponent) {
        return exponent == 0 ? 180 : Math.toDegrees(Math.acos(Math.pow(0.5, 1 / exponent)));
    }

    private static Vec3 position(Vec3 local, Matrix4dc frame) {
        Vector3d at = frame.transformPosition(local.toVector());
        boolean within = Math.max(Math.abs(at.x), Math.max(Math.abs(at.y), Math.abs(at.z))) <= 1e7;
        return within ? Vec3.of(at) : null;
    }

    private static Vec3 direction(Vec3 local, Matrix4dc frame) {
        Vector3d turned = frame.transformDirection(local.toVector()).normalize();
        return turned.isFinite() ? Vec3.of(turned) : null;
    }

    private static Vec3 grey(double value) {
        return new Vec3(value, value, value);
    }

    List<Light> lights() {
        return List.copyOf(lights);
    }

    Environment environment(double ambient) {
        Sky sky = new Sky.Constant(Vec3.ZERO);
        return new Environment(sun, sky, grey(ambient), Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
    }
}
