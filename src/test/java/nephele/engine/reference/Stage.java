package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.IntBinaryOperator;
import nephele.engine.level.Body;
import nephele.engine.level.Environment;
import nephele.engine.level.Fog;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.PortalShape;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Sky;
import nephele.engine.level.Solid;
import nephele.engine.level.Sun;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.appearance.Decoding;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;

/** A level put together piece by piece, and what a few rays see of it. */
final class Stage {
    private Sun sun;
    private Sky sky;
    private Vec3 ambient;
    private Fog fog;
    private final List<Material> materials = new ArrayList<>();
    private final List<Solid> solids = new ArrayList<>();
    private final List<Light> lights = new ArrayList<>();
    private final List<PortalSpec> portals = new ArrayList<>();
    private final List<Body> bodies = new ArrayList<>();
    private final StagePictures pictures = new StagePictures();

    static Vec3 grey(double value) {
        return new Vec3(value, value, value);
    }

    Stage sun(Vec3 towards, double irradiance) {
        sun = new Sun(towards, grey(irradiance), true);
        return this;
    }

    Stage sky(Sky newSky) {
        sky = newSky;
        return this;
    }

    Stage ambient(double radiance) {
        ambient = grey(radiance);
        return this;
    }

    Stage fog(double extinctionPerMetre, Vec3 radiance) {
        fog = new Fog(extinctionPerMetre, radiance);
        return this;
    }

    Stage body(Body body) {
        bodies.add(body);
        return this;
    }

    Stage material(Material material) {
        materials.add(material);
        return this;
    }

    Stage lambert(String id, Vec3 albedo) {
        return material(new Material(id, albedo, null, null, null, null, Vec3.ZERO, 1));
    }

    Stage gloss(String id, Vec3 colour, double roughness, double metallic) {
        return material(new Material(id, colour, null, roughness, metallic, null, Vec3.ZERO, 1));
    }

    /** @param argbAt 0xaarrggbb of a pixel, row 0 at the top */
    Stage asset(String id, int width, int height, IntBinaryOperator argbAt) {
        pictures.put(id, width, height, argbAt);
        return this;
    }

    Stage box(String material, Vec3 centre, Vec3 size) {
        String id = "box" + solids.size();
        solids.add(new Solid.Box(id, material, false, TextureMapping.WORLD, centre, size, Map.of()));
        return this;
    }

    Stage solid(Solid solid) {
        solids.add(solid);
        return this;
    }

    Stage light(Light light) {
        lights.add(light);
        return this;
    }

    /** A rectangle 1 m × 2 m. */
    Stage portal(String id, String linkedTo, Vec3 centre, Vec3 normal) {
        Vec3 up = new Vec3(0, 1, 0);
        portals.add(new PortalSpec(id, linkedTo, centre, normal, up, 1, 2, PortalShape.RECTANGLE));
        return this;
    }

    Level level() {
        var environment = new Environment(sun, sky, ambient, 0, ToneCurve.CLIP, fog, List.of());
        return new Level(
                "stage", "", environment, null, List.of(), materials, solids, lights, portals, List.of(), bodies, null);
    }

    float[] picture(Pinhole eye, TraceSettings settings) {
        return ReferencePicture.trace(
                TracedLevel.of(PlacedLevel.of(level(), pictures), Decoding.SRGB), eye, settings, done -> {});
    }

    /** The one pixel of a picture that is hardly larger than a point. */
    float[] towards(Vec3 from, Vec3 to, int samples) {
        return picture(eye(from, to, 1e-7), new TraceSettings(1, 1, samples, 1, 1));
    }

    static Pinhole eye(Vec3 from, Vec3 to, double halfWidth) {
        Basis basis = Basis.lookAt(from, to, new Vec3(0, 1, 0), Basis.WORLD);
        return new Pinhole(from, basis, halfWidth, halfWidth, 0.05, 1e4);
    }
}
