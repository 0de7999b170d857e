package nephele.engine.level.appearance;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;

/** Finds the faces of a level's solids that are mirrors. */
public final class MirrorFaces {
    private MirrorFaces() {}

    /** Returns the ids of the materials that are mirrors. */
    public static Set<String> materials(List<Material> materials) {
        Set<String> ids = new HashSet<>();
        materials.stream().filter(Material::mirror).forEach(material -> ids.add(material.id()));
        return ids;
    }

    /** Returns the index of the first material that makes a face of a solid a mirror, or −1. */
    public static int firstMaterial(Level level) {
        return first(level, material -> true);
    }

    private static int first(Level level, Predicate<Material> isMeant) {
        for (int i = 0; i < level.materials().size(); i++) {
            Material material = level.materials().get(i);
            if (material.mirror()
                    && isMeant.test(material)
                    && level.solids().stream().anyMatch(solid -> isOn(solid, material.id()::equals))) {
                return i;
            }
        }
        return -1;
    }

    /**
     * Returns the index of the first material that makes a face of a solid a mirror with a colour other than white, or
     * −1.
     */
    public static int firstTinted(Level level) {
        return first(level, material -> !material.baseColour().equals(new Vec3(1, 1, 1)));
    }

    public static boolean any(Level level) {
        return firstMaterial(level) >= 0;
    }

    private static boolean isOn(Solid solid, Predicate<String> isMirror) {
        return isMirror.test(solid.material())
                || SolidFaces.authored(solid).values().stream().anyMatch(face -> isMirror.test(face.material()));
    }
}
