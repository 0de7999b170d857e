package nephele.editor.draw;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;
import nephele.editor.pane.ViewMode;
import nephele.engine.level.Body;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Sky;
import nephele.engine.level.Solid;
import nephele.engine.level.Sun;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.appearance.MirrorFaces;
import nephele.engine.math.Vec3;

/**
 * Makes the level that a view mode draws. All modes but the game's own picture draw surfaces alone, in even light. It
 * remembers the last level, of which unchanged records stay the same objects; so it belongs to one document.
 */
final class ViewModeLevel {
    private static final String BODY = "body";
    private static final String PORTALABLE = "portalable";
    private static final String OTHERS = "others";
    private static final String SOLID = "solid";
    private static final String MODEL = "model";

    /** Faces that take portals bright, all others dark. */
    private static final List<Material> BY_PORTALS = List.of(
            plain(PORTALABLE, new Vec3(0.72, 0.9, 1)),
            plain(OTHERS, new Vec3(0.085, 0.07, 0.065)),
            plain(BODY, new Vec3(0.2, 0.14, 0.09)));

    /** One colour each for solids, models and movable bodies. */
    private static final List<Material> BY_COLLISION = List.of(
            plain(SOLID, new Vec3(0.32, 0.42, 0.55)),
            plain(MODEL, new Vec3(0.55, 0.75, 0.4)),
            plain(BODY, new Vec3(0.9, 0.5, 0.15)));

    private static final Vec3 AMBIENT = new Vec3(0.42, 0.42, 0.42);
    private static final Vec3 IRRADIANCE = new Vec3(1.8, 1.8, 1.8);

    private final ViewMode mode;
    /** A level without lights, portals, mirrors, exits and player. */
    private final Level empty;

    private final DerivedRecords<Material, Material> materials = new DerivedRecords<>(ViewModeLevel::withoutReflection);
    private final DerivedRecords<ModelPlacement, ModelPlacement> models;
    private final DerivedRecords<Body, Body> bodies = new DerivedRecords<>(body -> body.withMaterial(BODY));
    private DerivedRecords<Solid, Solid> solids =
            new DerivedRecords<>(solid -> recoloured(solid, (own, takes) -> SOLID));
    /** The materials that refuse portals; {@code null} before the first level. */
    private Set<String> mirrors;

    private Level drawn;

    /** @param background linear radiance behind the level, except in the game's own picture */
    ViewModeLevel(ViewMode mode, Vec3 background) {
        this.mode = mode;
        // The sun is above while no view is known.
        empty = Level.of("", "", evenLight(new Vec3(0, 1, 0), new Sky.Constant(background)), List.of());
        drawn = empty;
        models = new DerivedRecords<>(model ->
                model.withMaterial(mode == ViewMode.COLLISION ? MODEL : model.portalable() ? PORTALABLE : OTHERS));
    }

    /** Returns the level to draw; the same object if nothing visible of it has changed. */
    Level of(Level level) {
        return switch (mode) {
            case LIT, WIREFRAME -> level;
            case UNLIT -> surfaces(materials.of(level.materials()), level.solids(), level.models(), level.bodies());
            case PORTALABLE -> {
                followMirrors(level);
                yield recoloured(BY_PORTALS, level);
            }
            case COLLISION -> recoloured(BY_COLLISION, level);
        };
    }

    private void followMirrors(Level level) {
        Set<String> now = MirrorFaces.materials(level.materials());
        if (!now.equals(mirrors)) {
            mirrors = now;
            solids = new DerivedRecords<>(solid -> recoloured(
                    solid, (own, takes) -> takes && !(own != null && now.contains(own)) ? PORTALABLE : OTHERS));
        }
    }

    private Level recoloured(List<Material> colours, Level level) {
        return surfaces(colours, solids.of(level.solids()), models.of(level.models()), bodies.of(level.bodies()));
    }

    private Level surfaces(
            List<Material> colours, List<Solid> brushes, List<ModelPlacement> meshes, List<Body> movable) {
        boolean isSame = colours == drawn.materials()
                && brushes == drawn.solids()
                && meshes == drawn.models()
                && movable == drawn.bodies();
        if (!isSame) {
            drawn = empty.with(colours, brushes, movable, meshes);
        }
        return drawn;
    }

    private static Material plain(String id, Vec3 colour) {
        return new Material(id, colour, null, null, null, null, Vec3.ZERO, 1);
    }

    private static Material withoutReflection(Material authored) {
        return new Material(
                authored.id(),
                authored.baseColour(),
                authored.texture(),
                null,
                null,
                null,
                authored.emission(),
                authored.textureMetres(),
                false);
    }

    /**
     * Returns a solid whose faces have other materials. These are plain, so that placements of pictures are dropped.
     *
     * @param choice chooses a face's material from its own one, {@code null} for grey, and from whether it takes portals
     */
    private static Solid recoloured(Solid solid, BiFunction<String, Boolean, String> choice) {
        BiFunction<String, Boolean, String> chosen = (material, portalable) -> choice.apply(
                material == null ? solid.material() : material, portalable == null ? solid.portalable() : portalable);
        Solid whole = solid.with(solid.id(), chosen.apply(null, null), solid.portalable(), solid.textureMapping());
        if (whole instanceof Solid.Box box) {
            return box.withFaces(recoloured(box.faces(), chosen));
        } else if (whole instanceof Solid.Wedge wedge) {
            return wedge.withFaces(recoloured(wedge.faces(), chosen));
        } else if (whole instanceof Solid.Prism prism) {
            return prism.withFaces(recoloured(prism.faces(), chosen));
        }
        Solid.Planes planes = (Solid.Planes) whole;
        return planes.withPlanes(planes.planes().stream()
                .map(face -> new Solid.PlaneFace(
                        face.normal(),
                        face.distanceMetres(),
                        chosen.apply(face.material(), face.portalable()),
                        face.portalable(),
                        null))
                .toList());
    }

    private static <K> Map<K, Solid.Face> recoloured(
            Map<K, Solid.Face> faces, BiFunction<String, Boolean, String> chosen) {
        Map<K, Solid.Face> others = new LinkedHashMap<>();
        faces.forEach((side, face) -> others.put(
                side, new Solid.Face(chosen.apply(face.material(), face.portalable()), face.portalable(), null)));
        return others;
    }

    /**
     * Returns the environment of the even light for a view. The sun is beside the eye, because faces that a fixed sun does
     * not reach would all look the same.
     */
    static Environment evenLight(Environment base, Vec3 right, Vec3 up, Vec3 back) {
        Vec3 towards = back.scaled(0.75).addScaled(0.45, up).addScaled(0.3, right);
        return evenLight(towards, base.sky());
    }

    /**
     * Returns light that is constant from everywhere, and a weak sun without shadows, so that the faces of a corner
     * differ. A white surface reaches at most 1.
     */
    private static Environment evenLight(Vec3 towardsSun, Sky sky) {
        Sun sun = new Sun(towardsSun, IRRADIANCE, false);
        return new Environment(sun, sky, AMBIENT, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
    }
}
