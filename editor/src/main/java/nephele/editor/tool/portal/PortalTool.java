package nephele.editor.tool.portal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import nephele.editor.document.PlacedLevelCache;
import nephele.editor.document.Selection;
import nephele.editor.document.Snapshot;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.proving.HeatText;
import nephele.editor.proving.PlacementHeatMap;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Words;
import nephele.editor.tool.PointedPlace;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.engine.asset.AssetException;
import nephele.engine.level.Level;
import nephele.engine.level.PortalGun;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.appearance.MirrorFaces;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Basis;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.Gun;
import nephele.engine.portal.placement.Placement;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.PlacementSurfaces;
import nephele.engine.portal.placement.ShotAids;
import nephele.engine.portal.placement.ShotRay;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.SimSettings;

/**
 * Opens pairs of portals where the game's gun would: the first click gives one, the second its partner; both are one
 * step. A drag from a portal that is selected moves it along the walls, where it does not slide down to the floor.
 */
public final class PortalTool implements Tool {
    public static final ToolEntry ENTRY = new ToolEntry(
            "portal",
            Words.of("Portals", "Portais", "Portais"),
            Words.of(
                    "Click twice for a pair of portals; drag a selected portal to move it",
                    "Clique duas vezes para um par de portais; arraste um portal selecionado para mover",
                    "Clica duas vezes para um par de portais; arrasta um portal selecionado para o mover"),
            "P",
            PortalTool::new);

    private static final Words PAIR = Words.of("Add portals", "Adicionar portais", "Adicionar portais");
    private static final Words MOVE = Words.of("Move portal", "Mover portal", "Mover portal");
    private static final Words GONE = Words.of(
            "The first portal no longer fits: place it again",
            "O primeiro portal não cabe mais: coloque de novo",
            "O primeiro portal já não cabe: volta a colocá-lo");
    private static final String SECTION = "portals";

    /** Beyond every level, and every plan's eye. */
    private static final double FARTHEST_METRES = 1e8;

    /** The aids of a game with the usual assists. */
    private static final ShotAids AIDS = new SimSettings(SimSettings.DEFAULT.ticksPerSecond(), Assist.USUAL).shotAids();

    private static final Vec3 UP = new Vec3(0, 1, 0);

    private final ToolContext context;
    private final PlacedLevelCache placedLevel;

    /** The level whose surfaces are prepared; they are prepared anew only when the shapes differ. */
    private Level preparedOf;

    private StaticShapes shapes;
    private PlacementSurfaces surfaces;

    /** The portal of the first click; not in the level before it has a partner. */
    private Portal first;
    /** The portal that a drag moves; {@code null} without one. */
    private PortalSpec moving;
    /** The result of a shot at the pointer; {@code null} before it is over the pane. */
    private PlacementResult aim;

    public PortalTool(ToolContext context) {
        this.context = context;
        placedLevel = new PlacedLevelCache(context.background());
    }

    @Override
    public void moved(Pointer pointer) {
        aim = shot("new", gun(), pointer, open(""));
    }

    private PortalGun gun() {
        PortalGun gun = context.document().level().portalGun();
        return gun == null ? PlacementHeatMap.DEFAULT_GUN : gun;
    }

    /** Returns the portals that are open, but for one that moves. */
    private List<Portal> open(String movingId) {
        List<Portal> open = new ArrayList<>();
        for (PortalSpec portal : context.document().level().portals()) {
            if (!portal.id().equals(movingId)) {
                open.add(Portal.of(portal));
            }
        }
        if (first != null) {
            open.add(first);
        }
        return open;
    }

    @Override
    public void left() {
        aim = null;
    }

    @Override
    public void pressed(Pointer pointer) {
        moving = first == null ? grabbed(pointer).orElse(null) : null;
        if (moving == null) {
            moved(pointer);
        }
    }

    /** Returns the selected portal under the pointer. */
    private Optional<PortalSpec> grabbed(Pointer pointer) {
        return context.picker().along(pointer.ray()).stream()
                .map(pick -> pick.entity())
                .filter(entity -> entity.section().equals(SECTION))
                .filter(context.document().selection()::contains)
                .findFirst()
                .flatMap(entity -> Entities.LEVEL.find(context.document().level(), entity))
                .map(PortalSpec.class::cast);
    }

    @Override
    public void dragged(Pointer pointer) {
        if (moving == null) {
            moved(pointer);
            return;
        }
        PortalGun own = new PortalGun(moving.widthMetres(), moving.heightMetres(), moving.shape(), 1, false);
        aim = shot(moving.id(), own, pointer, open(moving.id()));
        context.status(aimWords());
        if (aim instanceof PlacementResult.Fits fits) {
            PortalSpec there = spec(fits.portal(), moving.id(), moving.linkedTo());
            context.document()
                    .drag(before -> before.with(Entities.LEVEL.changed(
                            before.level(), List.of(new EntityRef(SECTION, moving.id())), portal -> there)));
        }
    }

    @Override
    public void released(Pointer pointer) {
        if (moving != null) {
            context.document().commitDrag(MOVE);
            moving = null;
        } else if (aim != null) {
            moved(pointer);
            click();
        }
        aim = null;
    }

    private void click() {
        if (first != null
                && !holds(
                        first,
                        gun(),
                        open("").stream().filter(portal -> portal != first).toList())) {
            first = null;
            context.status(GONE);
        } else if (!(aim instanceof PlacementResult.Fits fits)) {
            context.status(aimWords());
        } else if (first == null) {
            first = fits.portal();
        } else {
            Portal second = fits.portal();
            context.document().edit(PAIR, null, before -> paired(before, first, second));
            first = null;
        }
    }

    private Snapshot paired(Snapshot before, Portal one, Portal two) {
        String oneId = Entities.LEVEL.freshId(before.level(), SECTION, "portal-1");
        String twoId = Entities.LEVEL.freshId(before.level(), SECTION, "portal-2", Set.of(oneId));
        Level with = Entities.LEVEL.added(before.level(), SECTION, spec(one, oneId, twoId));
        return new Snapshot(
                Entities.LEVEL.added(with, SECTION, spec(two, twoId, oneId)),
                Selection.of(List.of(new EntityRef(SECTION, oneId), new EntityRef(SECTION, twoId))));
    }

    private static PortalSpec spec(Portal portal, String id, String linkedTo) {
        return new PortalSpec(
                id,
                linkedTo,
                PointedPlace.cleaned(portal.centre()),
                PointedPlace.cleaned(portal.normal()),
                PointedPlace.cleaned(portal.frame().up()),
                portal.aperture().widthMetres(),
                portal.aperture().heightMetres(),
                portal.aperture().shape());
    }

    /**
     * Returns the result of a shot along the ray of sight, as the game makes it with the usual assists, without a range.
     *
     * @param others portals that stay open
     */
    private PlacementResult shot(String id, PortalGun gun, Pointer pointer, List<Portal> others) {
        Ray ray = pointer.ray();
        Vec3 eye = new Vec3(ray.originX(), ray.originY(), ray.originZ());
        Vec3 sight = new Vec3(ray.directionX(), ray.directionY(), ray.directionZ());
        Vec3 up = pointer.isPlan() ? pointer.camera().up() : UP;
        // The difference to a far origin would lose digits of the direction.
        Basis view = Basis.lookAt(Vec3.ZERO, sight, up, Basis.WORLD);
        return placement(gun).place(id, new ShotRay(eye, view), others, Obstacles.NONE);
    }

    /** Returns true if a portal still fits where it is. */
    private boolean holds(Portal portal, PortalGun gun, List<Portal> others) {
        return placement(gun).holds(portal, others);
    }

    private Placement placement(PortalGun authored) {
        Gun gun = Gun.of(authored);
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
                    .map(assets -> placedLevel.of(level, assets).statics())
                    .orElseGet(() -> solids(level));
        } catch (AssetException | IllegalArgumentException unusable) {
            // A level with a model or solid that cannot be used counts without models.
            placedLevel.forget();
            return solids(level);
        }
    }

    private StaticShapes solids(Level level) {
        Set<String> mirrors = MirrorFaces.materials(level.materials());
        return StaticShapes.of(context.shapes().brushes().stream()
                .map(brush -> brush.refusingPortalsOn(mirrors))
                .toList());
    }

    @Override
    public void cancel() {
        context.document().cancelDrag();
        first = null;
        moving = null;
        aim = null;
    }

    @Override
    public List<Mark> marks() {
        List<Mark> marks = new ArrayList<>();
        if (first != null) {
            marks.addAll(outline(first, MarkColour.PREVIEW));
        }
        if (aim != null) {
            marks.addAll(aimMarks());
        }
        return marks;
    }

    private List<Mark> aimMarks() {
        return aim instanceof PlacementResult.Fits fits
                ? outline(fits.portal(), isSliding(fits) ? MarkColour.SLIDES : MarkColour.ALLOWED)
                : List.of(new Mark.Handle(((PlacementResult.Refused) aim).where(), MarkColour.REFUSED));
    }

    /** Returns the border of a portal, with a line in the direction in which it faces. */
    private static List<Mark> outline(Portal portal, MarkColour colour) {
        List<Mark> marks = new ArrayList<>(Mark.polygon(portal.corners(), colour, Mark.Visibility.ALWAYS));
        marks.add(new Mark.Line(portal.centre(), portal.world(0, 0, 0.3), colour, Mark.Visibility.ALWAYS));
        return marks;
    }

    private Words aimWords() {
        if (aim instanceof PlacementResult.Fits fits) {
            return (isSliding(fits) ? HeatText.SLIDES : HeatText.FITS).words(fits.slideMetres());
        }
        PlacementResult.Refused refused = (PlacementResult.Refused) aim;
        return HeatText.of(refused.reason()).words(refused.unevenMetres());
    }

    private static boolean isSliding(PlacementResult.Fits fits) {
        return fits.slideMetres() > PlacementHeatMap.AIMED_METRES;
    }

    @Override
    public Words hint() {
        return aim == null ? ENTRY.description() : aimWords();
    }
}
