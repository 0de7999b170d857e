package nephele.engine.reference;

import java.util.Optional;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.engine.reference.sky.LevelClouds;
import nephele.engine.reference.sky.SkyCover;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** A level prepared for ray tracing, with its bodies at their initial positions; immutable, shared by all threads. */
public final class TracedLevel {
    private final TracedItems rays;
    private final SurfaceAppearance looks;
    private final Illumination light;
    private final Shafts shafts;
    private final Optional<SkyRadiance> sky;
    private final Optional<LevelClouds> clouds;
    private final boolean sunCastsShadow;
    private final Optional<FogTransmittance> fog;
    private final Portals portals;
    private final ReflectingFaces mirrors;
    private final ExitLight exits;

    private TracedLevel(
            Level level, StaticShapes statics, AssetSource assets, Portals portals, ColourDecoding decoding) {
        this.portals = portals;
        rays = new TracedItems(
                statics, BodyPieces.of(level, portals), level.bodies().size());
        MaterialTextures textures = new MaterialTextures(level.materials(), assets, decoding);
        looks = new SurfaceAppearance(
                new FaceMaterials(statics.solids(), textures), new BodySurfaces(level.bodies(), textures), textures);
        mirrors = ReflectingFaces.of(statics.solids(), textures);
        sky = SkyRadiance.of(level.environment(), id -> PictureDecoder.decode(id, assets.bytes(id)), decoding);
        fog = FogTransmittance.of(level.environment());
        clouds = LevelClouds.of(level.environment(), assets, sky);
        sunCastsShadow =
                level.environment().sun() != null && level.environment().sun().castsShadow();
        light = new Illumination(
                level, SkyCover.of(clouds, level.environment().ambient() == null ? sky : Optional.empty()));
        exits = new ExitLight(level);
        shafts = new Shafts(rays, light.shafts());
    }

    /**
     * Prepares the level with its initial portals.
     *
     * @param decoding of the pictures of materials and sky
     * @throws nephele.engine.asset.AssetException naming a picture that is missing or cannot be used
     */
    public static TracedLevel of(PlacedLevel placed, ColourDecoding decoding) {
        Level level = placed.level();
        return new TracedLevel(level, placed.statics(), placed.assets(), Portals.of(level), decoding);
    }

    Tracer tracer(Pinhole eye) {
        return new Tracer(this, eye, new EyePath(rays, portals, mirrors), new ShadowRays(rays, shafts));
    }

    /** Returns an object for one thread that finds clouds on eye paths; empty without clouds. */
    Optional<CloudSight> cloudSight() {
        return clouds.map(all -> new CloudSight(all.media(), new Walls(all.open(), rays, portals, sunCastsShadow)));
    }

    /** Returns an object for one thread that finds visible surfaces. */
    public VisibleSurface sight(Pinhole eye) {
        return new VisibleSurface(rays, new EyePath(rays, portals, mirrors), eye);
    }

    Illumination light() {
        return light;
    }

    /** Returns the surface point at the end of a path. */
    SurfacePoint surface(EyePath path, Vec3 place, Vector3dc toEye) {
        return rays.shape(path.item()).at(path, place, toEye, looks);
    }

    Vector3d sky(double eyeHeight, Vector3dc away) {
        return sky.map(all -> all.from(eyeHeight, away.x(), away.y(), away.z())).orElseGet(Vector3d::new);
    }

    ExitLight exits() {
        return exits;
    }

    /** Returns the share of light that passes the fog along a path of this length. */
    double transmittance(double metres) {
        return fog.map(all -> all.transmittance(metres)).orElse(1.0);
    }

    Vector3d throughFog(Vector3d radiance, double metres) {
        return fog.isPresent() ? fog.get().over(radiance, metres) : radiance;
    }
}
