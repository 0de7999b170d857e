package nephele.engine.level;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.math.Vec3;

/** Small levels for tests of drawing and tracing, built step by step. */
public final class TestLevel {
    private Sun sun;
    private Sky sky;
    private Vec3 ambient = Vec3.ZERO;
    private ToneCurve toneCurve = ToneCurve.CLIP;
    private Exposure exposure = Exposure.NEUTRAL;
    private Environment.Fog fog;
    private final List<Material> materials = new ArrayList<>();
    private final List<Solid> solids = new ArrayList<>();
    private final List<Light> lights = new ArrayList<>();
    private final List<PortalSpec> portals = new ArrayList<>();
    private final List<Body> bodies = new ArrayList<>();
    private final List<ModelPlacement> models = new ArrayList<>();
    private final List<Exit> exits = new ArrayList<>();
    private final List<Emitter> emitters = new ArrayList<>();
    private final List<Billboards> billboards = new ArrayList<>();
    private final List<Cloud> clouds = new ArrayList<>();
    private Environment.Lightning lightning;

    /** Adds a sun without shadows. */
    public TestLevel sun(Vec3 towards, double irradiance) {
        sun = new Sun(towards, grey(irradiance), false);
        return this;
    }

    public TestLevel castingSun(Vec3 towards, double irradiance) {
        sun = new Sun(towards, grey(irradiance), true);
        return this;
    }

    /** Uses light of the sky instead of an ambient constant, which is black unless given. */
    public TestLevel skyLight() {
        ambient = null;
        return this;
    }

    public TestLevel sky(Sky newSky) {
        sky = newSky;
        return this;
    }

    public TestLevel ambient(double radiance) {
        ambient = grey(radiance);
        return this;
    }

    public TestLevel toneMapping(ToneCurve curve, double stops) {
        toneCurve = curve;
        exposure = Exposure.ofStops(stops);
        return this;
    }

    public TestLevel autoExposure() {
        exposure = Exposure.AUTO;
        return this;
    }

    public TestLevel fog(double extinctionPerMetre, Vec3 radiance) {
        return fog(new Environment.Fog(extinctionPerMetre, radiance));
    }

    public TestLevel fog(Environment.Fog written) {
        fog = written;
        return this;
    }

    public TestLevel material(String id, Vec3 baseColour) {
        return material(new Material(id, baseColour, null, null, null, null, Vec3.ZERO, 1));
    }

    public TestLevel material(Material material) {
        materials.add(material);
        return this;
    }

    public TestLevel gloss(String id, Vec3 colour, double roughness, double metallic) {
        return material(new Material(id, colour, null, roughness, metallic, null, Vec3.ZERO, 1));
    }

    public TestLevel textured(String id, String texture) {
        return material(new Material(id, grey(1), texture, null, null, null, Vec3.ZERO, 1));
    }

    public TestLevel box(String material, Vec3 centre, Vec3 size) {
        return solid(new Solid.Box(
                "box" + solids.size(),
                material,
                false,
                TextureMapping.WORLD,
                centre,
                size,
                Map.<BoxFace, Solid.Face>of()));
    }

    public TestLevel solid(Solid solid) {
        solids.add(solid);
        return this;
    }

    /** Adds a portal without a rim or wall of its own. */
    public TestLevel portal(String id, String linkedTo, Vec3 centre, Vec3 normal, double width, double height) {
        Vec3 up = Math.abs(normal.y()) > 0.9 ? new Vec3(0, 0, -1) : new Vec3(0, 1, 0);
        return portal(new PortalSpec(id, linkedTo, centre, normal, up, width, height, PortalShape.RECTANGLE));
    }

    /** Adds a cube that can move. */
    public TestLevel cube(String material, Vec3 centre, double side) {
        return body(new Body.Box("body" + bodies.size(), centre, grey(side), 10, material, 0.6, 0));
    }

    public TestLevel body(Body body) {
        bodies.add(body);
        return this;
    }

    public TestLevel model(String file, String material, TransformStep... steps) {
        models.add(new ModelPlacement("model" + models.size(), file, null, List.of(steps), material, false));
        return this;
    }

    /** Adds a model that is drawn as an impostor where it is small. */
    public TestLevel impostor(String file, String material, TransformStep... steps) {
        model(file, material, steps);
        return planted(models.remove(models.size() - 1).asImpostor());
    }

    public TestLevel planted(ModelPlacement model) {
        models.add(model);
        return this;
    }

    public TestLevel portal(PortalSpec portal) {
        portals.add(portal);
        return this;
    }

    public TestLevel light(Light light) {
        lights.add(light);
        return this;
    }

    public TestLevel exit(Exit exit) {
        exits.add(exit);
        return this;
    }

    public TestLevel billboards(Billboards group) {
        billboards.add(group);
        return this;
    }

    public TestLevel emitter(Emitter emitter) {
        emitters.add(emitter);
        return this;
    }

    public TestLevel lightning(Environment.Lightning description) {
        lightning = description;
        return this;
    }

    public TestLevel cloud(Cloud cloud) {
        clouds.add(cloud);
        return this;
    }

    /** Adds a cloud that is an ellipsoid in a box. */
    public TestLevel cloud(Vec3 centre, Vec3 size, double extinctionPerMetre, double albedo, double phaseG) {
        return cloud(cloud(new Cloud.Extent.Volume(centre, size), extinctionPerMetre, albedo, phaseG));
    }

    /** Adds an endless homogeneous layer. */
    public TestLevel layer(double base, double thickness, double extinctionPerMetre, double albedo, double phaseG) {
        return cloud(cloud(new Cloud.Extent.Layer(base, thickness), extinctionPerMetre, albedo, phaseG));
    }

    private Cloud cloud(Cloud.Extent extent, double extinctionPerMetre, double albedo, double phaseG) {
        return new Cloud(
                "cloud" + clouds.size(),
                extent,
                CloudTechnique.AUTO,
                new Cloud.Density.Ellipsoid(),
                extinctionPerMetre,
                albedo,
                phaseG);
    }

    public Level level() {
        Environment environment = RecordCopy.with(
                new Environment(sun, sky, ambient, exposure, toneCurve, fog, List.copyOf(clouds)),
                "lightning",
                lightning);
        return Level.of("test", "", environment, List.of())
                .with(List.copyOf(materials), List.copyOf(solids), List.copyOf(bodies), List.copyOf(models))
                .with(environment, List.copyOf(lights))
                .withPortals(List.copyOf(portals))
                .withExits(List.copyOf(exits))
                .withEmitters(List.copyOf(emitters))
                .withBillboards(List.copyOf(billboards));
    }

    public static Vec3 grey(double value) {
        return new Vec3(value, value, value);
    }
}
