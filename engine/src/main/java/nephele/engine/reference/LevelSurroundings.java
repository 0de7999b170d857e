package nephele.engine.reference;

import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.portal.PortalCrossing;
import nephele.engine.portal.Portals;
import nephele.engine.reference.volume.DistantLight;
import nephele.engine.reference.volume.Surroundings;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The surroundings of the clouds of a level: light from outside, and every solid, body, model and open portal, seen from its
 * front, as a black wall. Use one per thread.
 */
final class LevelSurroundings implements Surroundings {
    private static final Vector3dc STRAIGHT = new Vector3d();

    private final Surroundings open;
    private final TracedItems surfaces;
    private final Portals portals;
    private final boolean hasPortals;
    private final boolean castShadows;
    private final PortalCrossing crossing = new PortalCrossing();
    private final Vector3d origin = new Vector3d();
    private final Vector3d direction = new Vector3d();

    /** @param castShadows false if sun and moon cast no shadows */
    LevelSurroundings(Surroundings open, TracedItems surfaces, Portals portals, boolean castShadows) {
        this.open = open;
        this.surfaces = surfaces;
        this.portals = portals;
        this.castShadows = castShadows;
        hasPortals = IntStream.range(0, portals.size()).anyMatch(portals::isOpen);
    }

    @Override
    public List<DistantLight> lights() {
        return open.lights();
    }

    @Override
    public Vec3 skylight(Vec3 from, Vec3 along) {
        return open.skylight(from, along);
    }

    @Override
    public double reachMetres(Ray ray) {
        return open.reachMetres(ray);
    }

    @Override
    public boolean isLightBlocked(Ray ray) {
        return castShadows && isPathBlocked(ray, Double.POSITIVE_INFINITY);
    }

    @Override
    public boolean isPathBlocked(Ray ray, double toMetres) {
        return surfaces.blocker(ray, toMetres, -1) >= 0 || hasPortals && crossesPortal(ray, toMetres);
    }

    private boolean crossesPortal(Ray ray, double toMetres) {
        origin.set(ray.originX(), ray.originY(), ray.originZ());
        direction.set(ray.directionX(), ray.directionY(), ray.directionZ());
        return crossing.find(portals, origin, direction, STRAIGHT, toMetres);
    }
}
