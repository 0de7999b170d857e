package nephele.engine.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Body;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Environment;
import nephele.engine.level.Fog;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Sky;
import nephele.engine.level.Solid;
import nephele.engine.level.Sun;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;

/** Small levels for drawing tests, put together piece by piece. */
final class TestLevel {
    private Sun sun;
    private Sky sky;
    private Vec3 ambient = Vec3.ZERO;
    private ToneCurve toneCurve = ToneCurve.CLIP;
    private double exposureStops;
    private Fog fog;
    private final List<Material> materials = new ArrayList<>();
    private final List<Solid> solids = new ArrayList<>();
    private final List<Light> lights = new ArrayList<>();
    private final List<PortalSpec> portals = new ArrayList<>();
    private final List<Body> bodies = new ArrayList<>();
    private final List<ModelPlacement> models = new ArrayList<>();

    TestLevel sun(Vec3 towards, double irradiance) {
        sun = new Sun(towards, grey(irradiance), false);
        return this;
    }

    TestLevel castingSun(Vec3 towards, double irradiance) {
        sun = new Sun(towards, grey(irradiance), true);
        return this;
    }

    /** Instead of an ambient constant, which is black unless given. */
    TestLevel skyLight() {
        ambient = null;
        return this;
    }

    TestLevel sky(Sky newSky) {
        sky = newSky;
        return this;
    }

    TestLevel ambient(double radiance) {
        ambient = grey(radiance);
        return this;
    }

    /** As {@link #sun}, with a shadow. */
    TestLevel shadowingSun(Vec3 towards, double irradiance) {
        sun = new Sun(towards, grey(irradiance), true);
        return this;
    }

    TestLevel develop(ToneCurve curve, double stops) {
        toneCurve = curve;
        exposureStops = stops;
        return this;
    }

    TestLevel fog(double extinctionPerMetre, Vec3 radiance) {
        fog = new Fog(extinctionPerMetre, radiance);
        return this;
    }

    TestLevel material(String id, Vec3 baseColour) {
        return material(new Material(id, baseColour, null, null, null, null, Vec3.ZERO, 1));
    }

    TestLevel material(Material material) {
        materials.add(material);
        return this;
    }

    TestLevel textured(String id, String texture) {
        return material(new Material(id, grey(1), texture, null, null, null, Vec3.ZERO, 1));
    }

    TestLevel box(String material, Vec3 centre, Vec3 size) {
        return solid(new Solid.Box(
                "box" + solids.size(),
                material,
                false,
                TextureMapping.WORLD,
                centre,
                size,
                Map.<BoxFace, Solid.Face>of()));
    }

    TestLevel solid(Solid solid) {
        solids.add(solid);
        return this;
    }

    /** A portal without rim or wall of its own. */
    TestLevel portal(String id, String linkedTo, Vec3 centre, Vec3 normal, double width, double height) {
        Vec3 up = Math.abs(normal.y()) > 0.9 ? new Vec3(0, 0, -1) : new Vec3(0, 1, 0);
        return portal(new PortalSpec(id, linkedTo, centre, normal, up, width, height, PortalShape.RECTANGLE));
    }

    /** A cube that may move. */
    TestLevel cube(String material, Vec3 centre, double side) {
        return body(new Body.Box("body" + bodies.size(), centre, grey(side), 10, material, 0.6, 0));
    }

    TestLevel body(Body body) {
        bodies.add(body);
        return this;
    }

    TestLevel model(String file, String material, TransformStep... steps) {
        models.add(new ModelPlacement("model" + models.size(), file, null, List.of(steps), material, false));
        return this;
    }

    TestLevel portal(PortalSpec portal) {
        portals.add(portal);
        return this;
    }

    TestLevel light(Light light) {
        lights.add(light);
        return this;
    }

    Level level() {
        Environment environment = new Environment(sun, sky, ambient, exposureStops, toneCurve, fog, List.of());
        return new Level(
                "test",
                "",
                environment,
                null,
                List.of(),
                List.copyOf(materials),
                List.copyOf(solids),
                List.copyOf(lights),
                List.copyOf(portals),
                List.copyOf(models),
                List.copyOf(bodies),
                null);
    }

    static Vec3 grey(double value) {
        return new Vec3(value, value, value);
    }
}
