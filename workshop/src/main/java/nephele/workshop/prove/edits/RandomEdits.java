package nephele.workshop.prove.edits;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import nephele.engine.level.Body;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.level.RecordCopy;
import nephele.engine.level.Solid;
import nephele.engine.level.Sun;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;

/** Seeded random edits of a {@link Town}, one record at a time, with occasional undo, as an author makes them. */
final class RandomEdits {
    /** The kinds of edits. */
    enum Kind {
        MOVE_SOLID,
        RESIZE_SOLID,
        ADD_SOLID,
        REMOVE_SOLID,
        PAINT_SOLID,
        CHANGE_MATERIAL,
        CHANGE_LIGHT,
        ADD_LIGHT,
        REMOVE_LIGHT,
        CHANGE_SUN,
        MOVE_PORTAL,
        MOVE_BODY,
        MOVE_MODEL,
        UNDO,
        TOGGLE_MIRROR,
        TOGGLE_SKY
    }

    /** The common kinds; the others change which features of the renderer a level needs. */
    static final List<Kind> COMMON = List.copyOf(EnumSet.complementOf(EnumSet.of(Kind.TOGGLE_MIRROR, Kind.TOGGLE_SKY)));

    private static final int MOST_UNDONE = 100;

    private final SplittableRandom random;
    private final Deque<Level> earlier = new ArrayDeque<>();
    private Level level;
    private int added;

    RandomEdits(long seed, Level level) {
        random = new SplittableRandom(seed);
        this.level = level;
    }

    /** Returns one of these kinds, all with the same probability. */
    Kind oneOf(List<Kind> kinds) {
        return kinds.get(random.nextInt(kinds.size()));
    }

    /** Returns the level after one more edit. */
    Level after(Kind kind) {
        if (kind == Kind.UNDO) {
            level = earlier.isEmpty() ? level : earlier.pop();
            return level;
        }
        earlier.push(level);
        if (earlier.size() > MOST_UNDONE) {
            earlier.removeLast();
        }
        level = edited(kind);
        return level;
    }

    private Level edited(Kind kind) {
        return switch (kind) {
            case MOVE_SOLID -> withSolids(changed(level.solids(), this::moved));
            case RESIZE_SOLID -> withSolids(changed(level.solids(), this::resized));
            case ADD_SOLID -> withSolids(with(level.solids(), addedSolid()));
            case REMOVE_SOLID -> withSolids(without(level.solids()));
            case PAINT_SOLID -> withSolids(changed(level.solids(), this::painted));
            case CHANGE_MATERIAL -> level.with(changed(level.materials(), this::changedMaterial), level.solids());
            case CHANGE_LIGHT -> withLights(changed(level.lights(), this::changedLight));
            case ADD_LIGHT -> withLights(with(level.lights(), addedLight()));
            case REMOVE_LIGHT ->
                withLights(level.lights().size() > Town.LIGHTS ? without(level.lights()) : level.lights());
            case CHANGE_SUN -> level.with(otherSun(level.environment()), level.lights());
            case MOVE_PORTAL -> {
                double along = 3 + 0.1 * random.nextInt(10);
                yield level.withPortals(List.of(Town.portal("a", "b", along), Town.portal("b", "a", along + 3)));
            }
            case MOVE_BODY -> level.with(level.materials(), level.solids(), changed(level.bodies(), this::movedBody));
            case MOVE_MODEL ->
                level.with(
                        level.materials(), level.solids(), level.bodies(), changed(level.models(), this::movedModel));
            case TOGGLE_MIRROR -> level.with(changed(level.materials(), RandomEdits::toggledMirror), level.solids());
            case TOGGLE_SKY -> level.with(toggledSky(level.environment()), level.lights());
            case UNDO -> throw new IllegalArgumentException("an undo is no edit of its own");
        };
    }

    private Level withSolids(List<Solid> solids) {
        return level.with(level.materials(), solids);
    }

    private Level withLights(List<Light> lights) {
        return level.with(level.environment(), lights);
    }

    private <T> List<T> changed(List<T> list, UnaryOperator<T> change) {
        List<T> changed = new ArrayList<>(list);
        int at = random.nextInt(list.size());
        changed.set(at, change.apply(list.get(at)));
        return List.copyOf(changed);
    }

    private <T> List<T> without(List<T> list) {
        List<T> left = new ArrayList<>(list);
        left.remove(random.nextInt(list.size()));
        return List.copyOf(left);
    }

    private <T> List<T> with(List<T> list, T element) {
        List<T> more = new ArrayList<>(list);
        more.add(random.nextBoolean() ? list.size() : random.nextInt(list.size() + 1), element);
        return List.copyOf(more);
    }

    /** Returns a multiple of 10 cm or any value, from −1 m to 1 m. */
    private double step() {
        return random.nextBoolean() ? 0.1 * (random.nextInt(21) - 10) : 2 * random.nextDouble() - 1;
    }

    private Vec3 near(Vec3 place) {
        return new Vec3(place.x() + step(), place.y() + 0.2 * step(), place.z() + step());
    }

    private Vec3 scaled(Vec3 size) {
        double factor = 0.5 + random.nextDouble();
        return random.nextBoolean()
                ? new Vec3(factor * size.x(), size.y(), size.z())
                : new Vec3(size.x(), size.y(), factor * size.z());
    }

    private Solid moved(Solid solid) {
        if (solid instanceof Solid.Box box) {
            return box(box, box.material(), near(box.centre()), box.size());
        } else if (solid instanceof Solid.Wedge wedge) {
            return wedge(wedge, wedge.material(), near(wedge.centre()), wedge.size());
        }
        Solid.Prism prism = (Solid.Prism) solid;
        return prism(prism, prism.material(), near(prism.centre()), prism.radiusMetres());
    }

    private Solid resized(Solid solid) {
        if (solid instanceof Solid.Box box) {
            return box(box, box.material(), box.centre(), scaled(box.size()));
        } else if (solid instanceof Solid.Wedge wedge) {
            return wedge(wedge, wedge.material(), wedge.centre(), scaled(wedge.size()));
        }
        Solid.Prism prism = (Solid.Prism) solid;
        return prism(prism, prism.material(), prism.centre(), prism.radiusMetres() * (0.5 + random.nextDouble()));
    }

    private Solid painted(Solid solid) {
        String material =
                level.materials().get(random.nextInt(level.materials().size())).id();
        if (solid instanceof Solid.Box box) {
            return box(box, material, box.centre(), box.size());
        } else if (solid instanceof Solid.Wedge wedge) {
            return wedge(wedge, material, wedge.centre(), wedge.size());
        }
        Solid.Prism prism = (Solid.Prism) solid;
        return prism(prism, material, prism.centre(), prism.radiusMetres());
    }

    private static Solid box(Solid.Box box, String material, Vec3 centre, Vec3 size) {
        return new Solid.Box(box.id(), material, box.portalable(), box.textureMapping(), centre, size, box.faces());
    }

    private static Solid wedge(Solid.Wedge wedge, String material, Vec3 centre, Vec3 size) {
        TextureMapping mapping = wedge.textureMapping();
        return new Solid.Wedge(
                wedge.id(), material, wedge.portalable(), mapping, centre, size, wedge.rising(), wedge.faces());
    }

    private static Solid prism(Solid.Prism prism, String material, Vec3 centre, double radius) {
        TextureMapping mapping = prism.textureMapping();
        return new Solid.Prism(
                prism.id(),
                material,
                prism.portalable(),
                mapping,
                centre,
                radius,
                prism.heightMetres(),
                prism.sides(),
                prism.faces());
    }

    /** Returns a box on the middle of another box, or within 10 m of the town's corner if the other solid is no box. */
    private Solid addedSolid() {
        Solid on = level.solids().get(random.nextInt(level.solids().size()));
        Vec3 at = on instanceof Solid.Box box
                ? new Vec3(
                        box.centre().x(),
                        box.centre().y() + box.size().y() / 2 + 0.5,
                        box.centre().z())
                : new Vec3(10 * random.nextDouble(), 1, 10 * random.nextDouble());
        String id = "added" + added++;
        Vec3 size = new Vec3(0.5 + random.nextInt(3), 1, 0.5 + random.nextInt(3));
        return new Solid.Box(id, on.material(), true, TextureMapping.WORLD, at, size, Map.of());
    }

    private Material changedMaterial(Material old) {
        Vec3 colour = new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble());
        double metres = random.nextBoolean() ? old.textureMetres() : 1 + random.nextInt(3);
        return material(old, colour, metres, old.mirror());
    }

    private static Material toggledMirror(Material old) {
        return material(old, old.baseColour(), old.textureMetres(), !old.mirror());
    }

    private static Material material(Material old, Vec3 colour, double metres, boolean mirror) {
        return new Material(
                old.id(),
                colour,
                old.texture(),
                old.roughness(),
                old.metallic(),
                old.normalTexture(),
                old.emission(),
                metres,
                mirror);
    }

    /** Switches the ambient light between the sky's and a constant. */
    private static Environment toggledSky(Environment old) {
        Vec3 ambient = old.ambient() == null ? new Vec3(0.2, 0.2, 0.2) : null;
        return old.withAmbient(ambient);
    }

    private Light changedLight(Light light) {
        Vec3 intensity = new Vec3(10 * random.nextDouble(), 5, 4);
        Vec3 at = random.nextBoolean() ? light.position() : near(light.position());
        if (light instanceof Light.Spot spot) {
            return RecordCopy.with(spot, "position", at, "radiantIntensity", intensity);
        }
        return RecordCopy.with(
                (Light.Point) light,
                "position",
                at,
                "radiantIntensity",
                intensity,
                "castsShadow",
                random.nextBoolean());
    }

    private Light addedLight() {
        Light by = level.lights().get(random.nextInt(level.lights().size()));
        return new Light.Point("lamp" + added++, near(by.position()), new Vec3(5, 5, 5), 8, true);
    }

    private Environment otherSun(Environment old) {
        Sun sun = new Sun(new Vec3(step(), 1, step()), new Vec3(3, 3, 3), true);
        return old.with(sun).with(Exposure.ofStops(step()));
    }

    private Body movedBody(Body body) {
        Body.Box box = (Body.Box) body;
        return new Body.Box(
                box.id(),
                near(box.centre()),
                box.size(),
                box.massKilograms(),
                box.material(),
                box.friction(),
                box.restitution());
    }

    private ModelPlacement movedModel(ModelPlacement model) {
        Vec3 by = ((TransformStep.Translate) model.transform().get(0)).by();
        return model.withTransform(List.of(new TransformStep.Translate(near(by))));
    }
}
