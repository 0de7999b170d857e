package nephele.editor.pane;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import nephele.editor.pane.Mark.Visibility;
import nephele.engine.level.Billboards;
import nephele.engine.level.Body;
import nephele.engine.level.Camera;
import nephele.engine.level.Cloud;
import nephele.engine.level.Emitter;
import nephele.engine.level.Exit;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Place;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.scene.View;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerDimensions.Stance;

/**
 * Makes the symbols of a level's entities. Entities are named {@code section/id} as in {@link
 * nephele.engine.level.EditorNotes}; the player's start is {@code player}. Hidden ones have no symbol.
 */
public final class EntityMarks {
    private static final double FARTHEST_METRES = 1e7;
    private static final double CAMERA_METRES = 0.5;
    private static final double CAMERA_ASPECT = 16.0 / 9;
    /** A path is drawn with at most about so many lines. */
    private static final int MOST_PATH_LINES = 500;

    private static final double LIGHT_METRES = 0.18;
    private static final double SPOT_AXIS_METRES = 0.6;

    private final List<Mark> marks = new ArrayList<>();
    private final Set<String> selected;
    private final Set<String> hidden;

    private EntityMarks(Set<String> selected, Set<String> hidden) {
        this.selected = selected;
        this.hidden = hidden;
    }

    /**
     * Returns the marks of everything without a surface, and of selected models, bodies and terrains.
     *
     * @param shapes the level's, for the bounds of its models
     * @param selected names of entities that have the colour of the selection and show more of themselves
     */
    public static List<Mark> of(Level level, StaticShapes shapes, Set<String> selected) {
        EntityMarks all = new EntityMarks(selected, new HashSet<>(level.editor().hidden()));
        level.lights().forEach(all::light);
        if (level.player() != null) {
            all.player(level.player());
        }
        level.exits().forEach(all::exit);
        if (level.landmark() != null) {
            all.place("landmark", "landmark", level.landmark());
        }
        level.hints().stream()
                .filter(hint -> hint.near() != null)
                .forEach(hint -> all.place("hints/" + hint.id(), hint.id(), hint.near()));
        level.emitters().forEach(all::emitter);
        level.billboards().forEach(all::billboards);
        level.cameras().forEach(all::camera);
        level.environment().clouds().forEach(all::cloud);
        level.portals().forEach(portal -> all.portal(portal, level));
        level.bodies().forEach(all::body);
        shapes.models().all().forEach(all::model);
        shapes.ground().forEach(all::terrain);
        return List.copyOf(all.marks);
    }

    private boolean isHidden(String name) {
        return hidden.contains(name);
    }

    private SymbolLines wires(String name) {
        return selected.contains(name)
                ? new SymbolLines(marks, MarkColour.SELECTED, Visibility.ALWAYS)
                : new SymbolLines(marks, MarkColour.ENTITY, Visibility.HIDDEN_BY_SURFACES);
    }

    private void light(Light light) {
        String name = "lights/" + light.id();
        if (isFar(light.position()) || isHidden(name)) {
            return;
        }
        addLight(light, wires(name));
        if (selected.contains(name)) {
            addReach(light, new SymbolLines(marks, MarkColour.SELECTED, Visibility.HIDDEN_BY_SURFACES));
        }
    }

    private void player(PlayerStart start) {
        if (isHidden("player")) {
            return;
        }
        SymbolLines wires = wires("player");
        wires.capsule(start.feet(), PlayerDimensions.RADIUS_METRES, Stance.STANDING.heightMetres());
        Basis facing = Basis.ofYawPitch(Math.toRadians(start.yawDegrees()), Math.toRadians(start.pitchDegrees()));
        Vec3 eye = start.feet().plus(new Vec3(0, Stance.STANDING.eyeMetres(), 0));
        wires.arrow(eye, eye.addScaled(-0.9, facing.back()), facing.right());
    }

    private void exit(Exit exit) {
        String name = "exits/" + exit.id();
        if (!isHidden(name)) {
            wires(name).cylinder(exit.feet(), exit.radiusMetres(), exit.heightMetres());
        }
    }

    private void place(String name, String label, Place place) {
        if (!isFar(place.position()) && !isHidden(name)) {
            wires(name).sphere(place.position(), place.radiusMetres());
            wires(name).label(place.position(), label);
        }
    }

    private void emitter(Emitter emitter) {
        String name = "emitters/" + emitter.id();
        if (!isHidden(name)) {
            Aabb box = Aabb.around(emitter.centre(), emitter.size());
            wires(name).box(box);
            wires(name).label(new Vec3(box.minX(), box.maxY(), box.maxZ()), emitter.id());
        }
    }

    private void billboards(Billboards group) {
        String name = "billboards/" + group.id();
        if (selected.contains(name) && !isHidden(name) && !group.at().isEmpty()) {
            wires(name).box(group.listedBounds());
        }
    }

    private void camera(Camera camera) {
        String name = "cameras/" + camera.id();
        if (isHidden(name)) {
            return;
        }
        addCamera(camera, wires(name));
        if (selected.contains(name)) {
            addPath(camera, new SymbolLines(marks, MarkColour.GUIDE, Visibility.ALWAYS));
        }
    }

    private void cloud(Cloud cloud) {
        String name = "environment.clouds/" + cloud.id();
        if (cloud.extent() instanceof Cloud.Extent.Volume volume && !isHidden(name)) {
            Aabb box = Aabb.around(volume.centre(), volume.size());
            wires(name).box(box);
            wires(name).label(new Vec3(box.minX(), box.maxY(), box.maxZ()), cloud.id());
        }
    }

    private void portal(PortalSpec spec, Level level) {
        String name = "portals/" + spec.id();
        if (isHidden(name) || !(spec.normal().length() > 0)) {
            return;
        }
        SymbolLines wires = wires(name);
        Portal portal = Portal.of(spec);
        wires.outline(portal.corners());
        Vec3 front = portal.centre().addScaled(0.5, portal.normal());
        wires.arrow(portal.centre(), front, portal.frame().right());
        wires.line(
                portal.centre(),
                portal.centre()
                        .addScaled(spec.heightMetres() / 4, portal.frame().up()));
        level.portals().stream()
                .filter(other -> other.id().equals(spec.linkedTo()) && isFirst(spec, other))
                .forEach(other -> {
                    boolean isSelected = selected.contains(name) || selected.contains("portals/" + other.id());
                    Visibility visibility = isSelected ? Visibility.ALWAYS : Visibility.HIDDEN_BY_SURFACES;
                    marks.add(new Mark.Line(spec.centre(), other.centre(), MarkColour.GUIDE, visibility));
                });
    }

    /** Two portals that lead to each other have one line. */
    private static boolean isFirst(PortalSpec portal, PortalSpec other) {
        return !other.linkedTo().equals(portal.id()) || portal.id().compareTo(other.id()) < 0;
    }

    private void body(Body body) {
        String name = "bodies/" + body.id();
        if (selected.contains(name) && !isHidden(name)) {
            wires(name).box(Aabb.around(body.centre(), extent(body)));
        }
    }

    private static Vec3 extent(Body body) {
        if (body instanceof Body.Box box) {
            return box.size();
        } else if (body instanceof Body.Sphere sphere) {
            return new Vec3(1, 1, 1).scaled(2 * sphere.radiusMetres());
        }
        Body.Capsule capsule = (Body.Capsule) body;
        return new Vec3(2 * capsule.radiusMetres(), capsule.heightMetres(), 2 * capsule.radiusMetres());
    }

    private void model(PlacedModel model) {
        String name = "models/" + model.authored().id();
        if (selected.contains(name) && !isHidden(name) && !model.bounds().isEmpty()) {
            wires(name).box(model.bounds());
        }
    }

    private void terrain(StaticShape.HeightGrid ground) {
        String name = "terrains/" + ground.authored().id();
        if (selected.contains(name) && !isHidden(name)) {
            wires(name).box(ground.bounds());
        }
    }

    private static boolean isFar(Vec3 at) {
        return !(at.length() < FARTHEST_METRES);
    }

    /** Adds a small pyramid of the picture of a camera. */
    private static void addCamera(Camera camera, SymbolLines wires) {
        View view = View.ofCamera(camera, 0, CAMERA_ASPECT);
        Vec3 eye = view.eye();
        Vec3 middle = eye.addScaled(-CAMERA_METRES, view.back());
        Vec3 right = view.right().scaled(CAMERA_METRES * view.projection().tanHalfWidth());
        Vec3 up = view.up().scaled(CAMERA_METRES * view.projection().tanHalfHeight());
        List<Vec3> corners = List.of(
                middle.plus(right).plus(up),
                middle.minus(right).plus(up),
                middle.minus(right).minus(up),
                middle.plus(right).minus(up));
        wires.outline(corners);
        corners.forEach(corner -> wires.line(eye, corner));
        Vec3 top = middle.addScaled(1.4, up);
        wires.line(corners.get(0), top);
        wires.line(corners.get(1), top);
    }

    /** Adds the path of a camera, or without one the line to its target. */
    private static void addPath(Camera camera, SymbolLines wires) {
        List<Camera.Waypoint> path = camera.path();
        if (path.isEmpty()) {
            wires.line(camera.position(), camera.target());
            return;
        }
        int step = 1 + path.size() / MOST_PATH_LINES;
        for (int i = step; i < path.size(); i += step) {
            wires.line(path.get(i - step).position(), path.get(i).position());
        }
    }

    private static void addLight(Light light, SymbolLines wires) {
        Vec3 at = light.position();
        for (int corner = 0; corner < 4; corner++) {
            double y = (corner & 1) == 0 ? 1 : -1;
            double z = (corner & 2) == 0 ? 1 : -1;
            Vec3 ray = new Vec3(1, y, z).scaled(LIGHT_METRES / Math.sqrt(3));
            wires.line(at.minus(ray), at.plus(ray));
        }
        double half = LIGHT_METRES * 0.6;
        Vec3 up = new Vec3(0, half, 0);
        wires.outline(
                List.of(at.plus(up), at.plus(new Vec3(half, 0, 0)), at.minus(up), at.minus(new Vec3(half, 0, 0))));
        wires.outline(
                List.of(at.plus(up), at.plus(new Vec3(0, 0, half)), at.minus(up), at.minus(new Vec3(0, 0, half))));
        if (light instanceof Light.Spot spot && spot.direction().length() > 0) {
            Basis frame = facing(spot);
            wires.arrow(at, at.addScaled(-SPOT_AXIS_METRES, frame.back()), frame.right());
        }
    }

    private static Basis facing(Light.Spot spot) {
        return Basis.lookAt(Vec3.ZERO, spot.direction(), new Vec3(0, 1, 0), Basis.WORLD);
    }

    /** Adds where the light reaches. */
    private static void addReach(Light light, SymbolLines wires) {
        if (light instanceof Light.Spot spot && spot.direction().length() > 0) {
            cone(spot, spot.outerConeDegrees(), wires);
            cone(spot, spot.innerConeDegrees(), wires);
        } else {
            wires.sphere(light.position(), light.rangeMetres());
        }
    }

    private static void cone(Light.Spot spot, double halfAngleDegrees, SymbolLines wires) {
        Basis frame = facing(spot);
        double range = spot.rangeMetres();
        double along = range * Math.cos(Math.toRadians(halfAngleDegrees));
        double radius = range * Math.sin(Math.toRadians(halfAngleDegrees));
        Vec3 centre = spot.position().addScaled(-along, frame.back());
        Vec3 right = frame.right().scaled(radius);
        Vec3 up = frame.up().scaled(radius);
        wires.circle(centre, right, up);
        for (Vec3 side : List.of(right, up, right.negated(), up.negated())) {
            wires.line(spot.position(), centre.plus(side));
        }
    }
}
