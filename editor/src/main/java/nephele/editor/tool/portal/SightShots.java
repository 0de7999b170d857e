package nephele.editor.tool.portal;

import java.util.List;
import java.util.Set;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.ToolContext;
import nephele.editor.work.FollowedPlacement;
import nephele.engine.asset.AssetException;
import nephele.engine.level.Level;
import nephele.engine.level.PortalGun;
import nephele.engine.level.PortalShape;
import nephele.engine.level.appearance.MirrorFaces;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Basis;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.Gun;
import nephele.engine.portal.placement.MovingSurfaces;
import nephele.engine.portal.placement.Placement;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.PlacementSurfaces;
import nephele.engine.portal.placement.ShotAids;
import nephele.engine.portal.placement.ShotRay;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.SimSettings;

/**
 * Shots along the ray of sight, as the game makes them with the usual assists, but without a range. The surfaces are
 * prepared anew only when they differ.
 */
final class SightShots {
    static final PortalGun DEFAULT_GUN = new PortalGun(1.2, 2.1, PortalShape.ARCH, 500);

    /** Beyond every level, and every plan's eye. */
    private static final double FARTHEST_METRES = 1e8;

    /** The aids of a game with the usual assists. */
    private static final ShotAids AIDS = new SimSettings(SimSettings.DEFAULT.ticksPerSecond(), Assist.USUAL).shotAids();

    private static final Vec3 UP = new Vec3(0, 1, 0);

    private final ToolContext context;
    private Level preparedOf;
    private final FollowedPlacement placement;

    private StaticShapes shapes;
    private PlacementSurfaces surfaces;

    SightShots(ToolContext context) {
        this.context = context;
        placement = new FollowedPlacement(context.aside());
    }

    /**
     * Returns the result of a shot.
     *
     * @param others portals that stay open
     */
    PlacementResult shot(String id, PortalGun gun, Pointer pointer, List<Portal> others) {
        Ray ray = pointer.ray();
        Vec3 eye = new Vec3(ray.originX(), ray.originY(), ray.originZ());
        Vec3 sight = new Vec3(ray.directionX(), ray.directionY(), ray.directionZ());
        Vec3 up = pointer.isPlan() ? pointer.camera().up() : UP;
        // The difference to a far origin would lose digits of the direction.
        Basis view = Basis.lookAt(Vec3.ZERO, sight, up, Basis.WORLD);
        return placement(gun).place(id, new ShotRay(eye, view), others, MovingSurfaces.NONE);
    }

    /** Returns true if a portal still fits where it is. */
    boolean holds(Portal portal, PortalGun gun, List<Portal> others) {
        return placement(gun).holds(portal, others);
    }

    private Placement placement(PortalGun said) {
        Gun gun = Gun.of(said);
        return new Placement(surfaces(), new Gun(gun.aperture(), FARTHEST_METRES, gun.slideMetres(), gun.toFloor()))
                .with(AIDS);
    }

    private PlacementSurfaces surfaces() {
        Level level = context.document().level();
        if (level != preparedOf) {
            StaticShapes next = shapes(level);
            preparedOf = level;
            if (shapes == null || !shapes.equals(next)) {
                shapes = next;
                surfaces = PlacementSurfaces.of(next);
            }
        }
        return surfaces;
    }

    private StaticShapes shapes(Level level) {
        try {
            return context.assets()
                    .map(assets -> placement.of(level, assets).statics())
                    .orElseGet(() -> solids(level));
        } catch (AssetException | IllegalArgumentException unusable) {
            // A level with a model or solid that cannot be used counts without models.
            placement.forget();
            return solids(level);
        }
    }

    private StaticShapes solids(Level level) {
        Set<String> mirrors = MirrorFaces.materials(level.materials());
        return StaticShapes.of(context.shapes().brushes().stream()
                .map(brush -> brush.refusingPortalsOn(mirrors))
                .toList());
    }
}
