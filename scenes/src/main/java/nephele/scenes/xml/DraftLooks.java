package nephele.scenes.xml;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Material;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.math.Vec3;
import nephele.scenes.xml.XmlModel.Colours;

/** Converts display colours to materials of a level: one for each different appearance. */
final class DraftLooks {
    /** Least ambient light, so that a player sees the way in dark parts of a level. */
    private static final double LEAST_AMBIENT = 0.1;

    private final Map<Look, Material> looks = new LinkedHashMap<>();
    private double ambient;
    private double diffuse;

    /** @param texture {@code null} for none */
    private record Look(Colours colours, String texture, Vec3 tint) {}

    /**
     * Adds an appearance.
     *
     * @return the id of the material
     */
    String of(Colours colours, LevelDraft.Part part) {
        ambient += mean(linear(colours.ambient()));
        diffuse += mean(linear(colours.diffuse()));
        return looks.computeIfAbsent(
                        new Look(colours, part.texture(), part.tint()),
                        look -> material("look-" + (looks.size() + 1), look))
                .id();
    }

    /** Converts display colours to the linear ones of a level. */
    private static Material material(String id, Look look) {
        Colours colours = look.colours;
        boolean dull = colours.specular().equals(Vec3.ZERO);
        return new Material(
                id,
                linear(colours.diffuse()),
                look.texture,
                dull ? null : roughness(colours.shininess()),
                null,
                null,
                Vec3.of(linear(colours.emissive()).toVector().mul(look.tint.toVector())),
                1);
    }

    /**
     * Returns the roughness of microfacets whose highlight is as wide as Blinn's lobe: α² = 2 / (shininess + 2) (Walter
     * et al. 2007, section 5.2), where α is the roughness squared.
     */
    private static double roughness(double shininess) {
        return Math.pow(2 / (shininess + 2), 0.25);
    }

    private static Vec3 linear(Vec3 display) {
        return new Vec3(
                ColourDecoding.SRGB.linear(display.x()),
                ColourDecoding.SRGB.linear(display.y()),
                ColourDecoding.SRGB.linear(display.z()));
    }

    private static double mean(Vec3 colour) {
        return (colour.x() + colour.y() + colour.z()) / 3;
    }

    /** Returns the mean ambient reflectance of all surfaces relative to their diffuse reflectance. */
    double ambientFraction() {
        return diffuse > 0 ? Math.min(1, Math.max(LEAST_AMBIENT, ambient / diffuse)) : 1;
    }

    /**
     * Returns all materials, that of the floor included.
     *
     * @param floor its base colour
     */
    List<Material> materials(Vec3 floor) {
        List<Material> materials = new ArrayList<>(looks.values());
        materials.add(new Material(DraftGround.FLOOR, floor, null, null, null, null, Vec3.ZERO, 1));
        return List.copyOf(materials);
    }
}
