package nephele.engine.reference;

import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.Decoding;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portals;
import nephele.engine.reference.SampleSequence.Point;
import org.joml.Vector3d;

/** A level made ready for rays; immutable, shared by all threads. */
public final class TracedLevel {
    private final SolidRays solids;
    private final Surfaces surfaces;
    private final Illumination light;
    private final Optional<SkyRadiance> sky;
    private final Portals portals;

    private TracedLevel(Level level, AssetSource assets, Portals portals, Decoding decoding) {
        List<Brush> brushes = level.solids().stream().map(Brush::of).toList();
        this.portals = portals;
        solids = new SolidRays(brushes);
        surfaces = new Surfaces(brushes, level.materials(), assets, decoding);
        sky = SkyRadiance.of(level.environment().sky(), id -> PictureDecoder.decode(id, assets.bytes(id)), decoding);
        light = new Illumination(level, solids, sky);
    }

    /**
     * The level with the portals that it starts with.
     *
     * @param decoding of the pictures of materials and sky
     * @throws nephele.engine.asset.AssetException naming a picture that is missing or cannot be used
     */
    public static TracedLevel of(Level level, AssetSource assets, Decoding decoding) {
        return new TracedLevel(level, assets, Portals.of(level), decoding);
    }

    EyePath path() {
        return new EyePath(solids, portals);
    }

    /**
     * Radiance that reaches the eye along a ray, which {@code path} walks.
     *
     * @param skyPoints see {@link Illumination#radiance}
     */
    Vector3d radiance(EyePath path, Pinhole eye, Vector3d direction, IntFunction<Point> skyPoints) {
        if (path.walk(eye.eye().toVector(), direction, eye.nearMetres(), eye.farMetres())) {
            int face = solids.face(path.ray(), path.solid());
            Vec3 place = path.ray().at(path.end());
            Vector3d toEye = new Vector3d(path.direction()).normalize(-1);
            SurfacePoint surface = surfaces.at(path.solid(), face, place, toEye);
            return light.radiance(surface, skyPoints);
        }
        Vector3d away = new Vector3d(path.direction()).normalize();
        return sky.map(all -> all.from(away.x, away.y, away.z)).orElseGet(Vector3d::new);
    }
}
