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
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerDimensions.Stance;

/**
 * Makes the symbols of a level's entities. Entities are named {@code section/id} as in {@link
 * nephele.engine.level.EditorNotes}; the player's start is {@code player}. Hidden ones have no symbol.
 */
public final class EntityMarks {
    private static final double FARTHEST_METRES = 1e7;

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

    private Wires wires(String name) {
        return selected.contains(name)
                ? new Wires(marks, MarkColour.SELECTED, Visibility.ALWAYS)
                : new Wires(marks, MarkColour.ENTITY, Visibility.HIDDEN_BY_SURFACES);
    }

    private void light(Light light) {
        String name = "lights/" + light.id();
        if (isFar(light.position()) || isHidden(name)) {
            return;
        }
        LightSymbol.add(light, wires(name));
        if (selected.contains(name)) {
            LightSymbol.addReach(light, new Wires(marks, MarkColour.SELECTED, Visibility.HIDDEN_BY_SURFACES));
        }
    }

    private void player(PlayerStart start) {
        if (isHidden("player")) {
            return;
        }
        Wires wires = wires("player");
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
        CameraSymbol.add(camera, wires(name));
        if (selected.contains(name)) {
            CameraSymbol.addPath(camera, new Wires(marks, MarkColour.GUIDE, Visibility.ALWAYS));
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
        Wires wires = wires(name);
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
                    Visibility seen = isSelected ? Visibility.ALWAYS : Visibility.HIDDEN_BY_SURFACES;
                    marks.add(new Mark.Line(spec.centre(), other.centre(), MarkColour.GUIDE, seen));
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
        String name = "models/" + model.said().id();
        if (selected.contains(name) && !isHidden(name) && !model.bounds().isEmpty()) {
            wires(name).box(model.bounds());
        }
    }

    private void terrain(StaticShape.HeightGrid ground) {
        String name = "terrains/" + ground.said().id();
        if (selected.contains(name) && !isHidden(name)) {
            wires(name).box(ground.bounds());
        }
    }

    private static boolean isFar(Vec3 at) {
        return !(at.length() < FARTHEST_METRES);
    }
}
