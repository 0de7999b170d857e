package nephele.engine.reference;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.AirOfEnvironment;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.level.appearance.NightSky;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.engine.reference.sky.LevelClouds;
import nephele.engine.reference.sky.SkyCover;
import nephele.engine.reference.sky.SkyOfPaths;
import nephele.engine.reference.sky.SunDisc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** A level prepared for ray tracing, with its bodies at their initial positions; immutable, shared by all threads. */
public final class TracedLevel {
    private final TracedItems rays;
    private final TracedShape.SurfaceAppearance looks;
    private final Illumination light;
    private final Shafts shafts;
    private final Optional<SkyRadiance> sky;
    private final Optional<SkyOfPaths> skyOfPaths;
    private final Optional<LevelClouds> clouds;
    private final boolean sunCastsShadow;
    private final Optional<AirOfEnvironment> air;
    /** The shadows of clouds in the air. */
    private final Optional<AirShade> shade;

    /** The shadows of clouds and of walls, which paths with bounces see. */
    private final Optional<AirShade> shadeWithWalls;

    private final Optional<FogTransmittance> fog;
    private final Portals portals;
    private final EmissiveSurfaces emissive;
    private final Optional<SunDisc> disc;
    /** Its horizon is that of y = 0. */
    private final Optional<NightSky> night;

    private final ExitLight exits;

    private TracedLevel(PlacedLevel placed, Portals portals, ColourDecoding decoding, double seconds) {
        Level level = placed.level();
        StaticShapes statics = placed.statics();
        AssetSource assets = placed.assets();
        this.portals = portals;
        rays = new TracedItems(
                statics,
                BodyPiece.of(level, portals),
                level.bodies().size(),
                BillboardShape.of(placed, decoding, seconds),
                TriangleMeshShape.Planted.of(placed));
        MaterialTextures textures = new MaterialTextures(level.materials(), assets, decoding);
        looks = new TracedShape.SurfaceAppearance(
                FaceMaterials.of(statics.solids(), textures), new BodySurfaces(level.bodies(), textures), textures);
        emissive = new EmissiveSurfaces(rays, looks);
        disc = SunDisc.of(level.environment());
        night = night(level.environment());
        sky = SkyRadiance.of(level.environment(), id -> PictureDecoder.decode(id, assets.bytes(id)), decoding);
        air = AirOfEnvironment.of(level.environment());
        fog = FogTransmittance.of(level.environment());
        clouds = LevelClouds.of(level.environment(), assets, seconds, sky);
        shade = AirShade.ofClouds(level.environment(), clouds);
        sunCastsShadow =
                level.environment().sun() != null && level.environment().sun().castsShadow();
        shadeWithWalls = AirShade.of(
                level.environment(),
                clouds,
                ray -> sunCastsShadow && rays.blocker(ray, Double.POSITIVE_INFINITY, -1) >= 0);
        light = new Illumination(
                level, SkyCover.of(clouds, level.environment().ambient() == null ? sky : Optional.empty()));
        skyOfPaths = SkyOfPaths.of(level.environment(), sky);
        exits = new ExitLight(level);
        shafts = new Shafts(rays, light.shafts());
    }

    private static Optional<NightSky> night(Environment environment) {
        return environment.sky() instanceof Sky.Atmosphere sky && environment.sun() != null
                ? NightSky.of(sky, environment.sun(), 0)
                : Optional.empty();
    }

    /**
     * Prepares the level with its initial portals.
     *
     * @param decoding of the pictures of materials and sky
     * @throws nephele.engine.asset.AssetException naming a picture that is missing or cannot be used
     */
    public static TracedLevel of(PlacedLevel placed, ColourDecoding decoding) {
        return of(placed, decoding, 0);
    }

    /**
     * Prepares the level with its initial portals.
     *
     * @param decoding of the pictures of materials and sky
     * @param seconds simulated time at which the clouds are seen
     * @throws nephele.engine.asset.AssetException naming a picture that is missing or cannot be used
     */
    public static TracedLevel of(PlacedLevel placed, ColourDecoding decoding, double seconds) {
        return new TracedLevel(placed, Portals.of(placed.level()), decoding, seconds);
    }

    Tracer tracer(Pinhole eye, TraceSettings settings) {
        return tracer(eye, settings, PathIntegrator.Estimation.BOTH);
    }

    Tracer tracer(Pinhole eye, TraceSettings settings, PathIntegrator.Estimation estimation) {
        LightTransport transport = settings.light();
        var shadows = new Shafts.ShadowRays(rays, shafts);
        PathIntegrator bounced =
                transport.bounces() == 0 ? null : new PathIntegrator(this, transport, shadows, estimation);
        return new Tracer(this, eye, settings.width(), new EyePath(rays, portals, looks.solids()), shadows, bounced);
    }

    /**
     * Returns rays of a bake for one thread.
     *
     * @param panorama the sky as one place sees it; {@code null} if each ray is to find the sky itself
     */
    public GatherRays gatherRays(GatherRays.Sources sources, SkyPanorama panorama) {
        return new GatherRays(this, path(false), sources, panorama, new Shafts.ShadowRays(rays, shafts));
    }

    /** Returns rays that meet the sky and its clouds alone. */
    GatherRays skyRays() {
        var nothing = new TracedItems(StaticShapes.of(List.of()), List.of(), 0, List.of(), List.of());
        EyePath open = new EyePath(nothing, Portals.NONE, FaceMaterials.NONE);
        return new GatherRays(this, open, GatherRays.Sources.ALL, null, new Shafts.ShadowRays(rays, shafts));
    }

    /** Returns the sky as a place sees it; empty if it costs no more to ask the sky itself, or is no light. */
    public Optional<SkyPanorama> panorama(Vec3 eye) {
        return light.isSkyLight() && (air.isPresent() || clouds.isPresent())
                ? Optional.of(SkyPanorama.of(this, eye))
                : Optional.empty();
    }

    /** Returns the lamps that emit anything, in the order of the level. */
    public List<Light> lamps() {
        return light.lamps().stream().map(PunctualLight::source).toList();
    }

    /** Returns the kind of an item at which a ray ends. */
    GatherRays.End endOf(int item) {
        return rays.endOf(item);
    }

    /** Returns the index of an item among those of its kind. */
    int indexOf(int item) {
        return rays.indexOf(item);
    }

    /** Returns the face of the solid at a path's end, or the triangle of the model. */
    int partOf(EyePath path) {
        TracedShape shape = rays.shape(path.item());
        if (shape instanceof TracedSolid solid) {
            return solid.face(path.ray());
        }
        return shape instanceof TriangleMeshShape mesh ? mesh.triangle(path.ray(), path.end()) : 0;
    }

    /** Returns a finder of paths for one thread. */
    EyePath path(boolean passesPortals) {
        return new EyePath(rays, passesPortals ? portals : Portals.NONE, looks.solids());
    }

    /** Returns a finder of light through openings for one thread; without portals it is that off mirrors. */
    LightImages lightImages(boolean passesPortals) {
        return new LightImages(
                passesPortals ? portals : Portals.NONE, looks.solids().mirrors(), path(passesPortals), light);
    }

    EmissiveSurfaces emissive() {
        return emissive;
    }

    public boolean hasClouds() {
        return clouds.isPresent();
    }

    /**
     * Returns the fraction of a light from outside the level that passes the clouds on its way to a place, as the mean of
     * random estimates.
     *
     * @param towardsLight unit
     */
    public double shareThroughClouds(Vec3 place, Vec3 towardsLight, int estimates, long seed) {
        if (clouds.isEmpty()) {
            return 1;
        }
        var random = new SplittableRandom(seed);
        Ray ray = Ray.of(place, towardsLight);
        double reach = clouds.get().reachMetres(ray);
        double sum = 0;
        for (int i = 0; i < estimates; i++) {
            sum += clouds.get().media().transmittance(ray, 0, reach, random);
        }
        return sum / estimates;
    }

    /** Returns an object for one thread that finds clouds on eye paths; empty without clouds. */
    Optional<CloudSight> cloudSight() {
        return clouds.map(all -> new CloudSight(
                all.media(), new CloudSight.LevelSurroundings(all.open(), rays, portals, sunCastsShadow)));
    }

    /**
     * Returns the light that clouds scatter towards paths of one thread; empty without clouds.
     *
     * @param passesPortals false if light meets the walls behind portals
     */
    Optional<CloudScattering> cloudScattering(boolean passesPortals) {
        return clouds.map(all -> new CloudScattering(
                all.media(),
                new CloudSight.LevelSurroundings(
                        all.open(), rays, passesPortals ? portals : Portals.NONE, sunCastsShadow),
                light.lamps()));
    }

    /** Returns an object for one thread that finds visible surfaces. */
    public VisibleSurface sight(Pinhole eye) {
        return new VisibleSurface(rays, new EyePath(rays, portals, looks.solids()), eye);
    }

    Illumination light() {
        return light;
    }

    /** Returns the surface point at the end of a path. */
    SurfacePoint surface(EyePath path, Vec3 place, Vector3dc toEye) {
        return rays.shape(path.item()).at(path, place, toEye, looks);
    }

    private Vector3d sky(double eyeHeight, Vector3dc away) {
        return sky.map(all -> all.from(eyeHeight, away.x(), away.y(), away.z())).orElseGet(Vector3d::new);
    }

    ExitLight exits() {
        return exits;
    }

    /**
     * Returns the fraction of light that passes the fog.
     *
     * @param segment the part of the path that ends at the light
     * @param metres length of the path
     */
    double fogTransmittance(EyePath.Segment segment, double metres) {
        return fog.map(all -> all.transmittance(
                        segment.straightEye().y(), segment.direction().y(), metres))
                .orElse(1.0);
    }

    /** Returns the radiance of the place at a path's end as seen through the air. */
    Vector3d throughAir(Vector3d radiance, Vec3 place, EyePath path, SplittableRandom random) {
        Vec3 direction = Vec3.of(new Vector3d(path.direction()).normalize());
        return throughAir(radiance, place, direction, path.metres(), random);
    }

    /**
     * Returns the radiance of a place as seen through the air and the shadows of clouds in it.
     *
     * @param direction unit vector from the eye, at the place
     * @param metres length of the path
     */
    Vector3d throughAir(Vector3d radiance, Vec3 place, Vec3 direction, double metres, SplittableRandom random) {
        if (air.isEmpty()) {
            return radiance;
        }
        Vector3d arriving = air.get().over(radiance, place, direction.toVector(), metres);
        Vec3 eye = place.addScaled(-metres, direction);
        shade.ifPresent(all -> arriving.sub(all.taken(eye, direction, metres, random)));
        return arriving;
    }

    /** Returns what an eye sees at a path's end where nothing is. */
    Vector3d sky(double eyeHeight, EyePath path, SplittableRandom random) {
        Vector3d away = new Vector3d(path.direction()).normalize();
        Vector3d arriving = sky(eyeHeight, away);
        shade.ifPresent(
                all -> arriving.sub(all.taken(path.lastSegment().straightEye(), Vec3.of(away), path.metres(), random)));
        return arriving;
    }

    /**
     * Returns the fraction of the light of a place that passes the air, for each channel.
     *
     * @param direction unit vector from the eye, at the place
     * @param metres length of the path
     */
    Vector3d airTransmittance(Vec3 place, Vec3 direction, double metres) {
        return air.map(all -> all.transmittance(place, direction.toVector(), metres))
                .orElseGet(() -> new Vector3d(1));
    }

    /** Returns radiance seen through the fog; parameters as in {@link #fogTransmittance}. */
    Vector3d throughFog(Vector3d radiance, EyePath.Segment segment, double metres) {
        return fog.isPresent()
                ? fog.get()
                        .over(
                                radiance,
                                segment.straightEye().y(),
                                segment.direction().y(),
                                metres)
                : radiance;
    }

    /** Returns radiance of the place at a path's end as it arrives at its beginning, through air, fog and mirrors. */
    Vector3d arriving(Vector3d radiance, Vec3 place, EyePath path, SplittableRandom random) {
        Vector3d seen = throughAir(radiance, place, path, random);
        return mirrored(throughFog(seen, path.lastSegment(), path.metres()), path.tint(), path.reflected());
    }

    /** Returns the sky's radiance as it arrives along a path that ends at nothing. */
    Vector3d fromSky(EyePath path, SplittableRandom random) {
        Vector3d seen = sky(path.lastSegment().origin().y(), path, random);
        Vector3d radiance = throughFog(seen, path.lastSegment(), Double.POSITIVE_INFINITY);
        return mirrored(radiance, path.tint(), path.reflected());
    }

    /** Returns the radiance of the sky, without sun and moon, where the last part of a path begins. */
    Vector3d sky(EyePath.Segment last) {
        return sky(last.origin().y(), last.direction().toVector());
    }

    /** Returns a random radiance with the mean of {@link #sky(EyePath.Segment)}, for paths of light: a picture has many. */
    Vector3d skyOfPath(EyePath.Segment last, SplittableRandom random) {
        return skyOfPaths
                .map(all -> all.radiance(last.origin().y(), last.direction(), random))
                .orElseGet(Vector3d::new);
    }

    /**
     * Returns the radiance of the discs of sun and moon and of stars where the last part of a path begins.
     *
     * @param pixelRadians of the picture; a star fills about one
     */
    Vector3d discs(EyePath.Segment last, double pixelRadians) {
        Vec3 sunDisc = disc.map(
                        sun -> sun.towards(last.direction(), last.origin().y()))
                .orElse(Vec3.ZERO);
        Vec3 atNight = night.map(sky -> sky.moon(last.direction()).plus(sky.stars(last.direction(), pixelRadians)))
                .orElse(Vec3.ZERO);
        return sunDisc.plus(atNight).toVector();
    }

    /** Returns a random effect of air and mirrors along parts of a path; see {@link PathAir#of}. */
    PathAir air(List<EyePath.Segment> parts, SplittableRandom random) {
        return PathAir.of(air, shadeWithWalls, parts, random);
    }

    /**
     * Returns radiance as it arrives at an eye through air, each part's by its own place, and through fog and mirrors.
     *
     * @param radiance at the end of the parts; changed
     * @param parts of the path up to there
     * @param metres length of the path up to there; infinite for the sky
     */
    Vector3d arrivingByParts(
            Vector3d radiance, EyePath path, List<EyePath.Segment> parts, double metres, SplittableRandom random) {
        PathAir onWay = air(parts, random);
        EyePath.Segment last = parts.get(parts.size() - 1);
        Vector3d seen = radiance.mul(onWay.passed()).add(onWay.added()).mul(fogTransmittance(last, metres));
        List<EyePath.Reflected> before = path.reflected().stream()
                .filter(mirror -> parts.contains(mirror.before()))
                .toList();
        return seen.add(mirrored(throughFog(new Vector3d(), last, metres), last.tint(), before));
    }

    /**
     * Returns the fraction of light that passes air, fog and mirrors to an eye.
     *
     * @param part of its path
     * @param metres from the part's beginning
     */
    Vector3d attenuation(EyePath.Segment part, double metres) {
        return airAttenuation(part, metres).mul(fogTransmittance(part, part.metresBefore() + metres));
    }

    /** Returns the fraction of light that passes air and mirrors, likewise. */
    Vector3d airAttenuation(EyePath.Segment part, double metres) {
        Vec3 place = part.origin().addScaled(metres, part.direction());
        return airTransmittance(place, part.direction(), part.metresBefore() + metres)
                .mul(part.tint());
    }

    /** Returns the radiance of a cloud's collision as it arrives along a path. */
    Vector3d fromCloud(CloudSight.Met cloud, CloudSight clouds, EyePath path, SplittableRandom random) {
        Vec3 place = cloud.ray().at(cloud.collision().metres());
        Vector3d scattered = clouds.radiance(cloud, random);
        Vector3d seen = throughAir(scattered, place, cloud.segment().direction(), cloud.metres(), random);
        Vector3d radiance = throughFog(seen, cloud.segment(), cloud.metres());
        List<EyePath.Reflected> before = path.reflected().stream()
                .filter(mirror -> mirror.metres() <= cloud.segment().metresBefore())
                .toList();
        return mirrored(radiance, cloud.segment().tint(), before);
    }

    /**
     * Applies the mirrors to radiance that has passed all the fog: the fog in front of a mirror is not tinted by it.
     */
    private Vector3d mirrored(Vector3d radiance, Vector3dc tint, List<EyePath.Reflected> mirrors) {
        radiance.mul(tint);
        for (EyePath.Reflected mirror : mirrors) {
            radiance.add(
                    throughFog(new Vector3d(), mirror.before(), mirror.metres()).mul(mirror.lost()));
        }
        return radiance;
    }
}
