package nephele.lab.generate;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import nephele.engine.model.Mesh;

/**
 * A kind of plant or rock. Its mesh stands at the origin; its root or foot reaches a little below, so that it also
 * stands on uneven ground.
 *
 * @param family {@code tree} for what grows, {@code rock} otherwise
 * @param word its name in commands and file names
 * @param heightMetres from the ground to the top
 * @param grower adds the shape in any scale
 */
public record PlantKind(Family family, String word, double heightMetres, BiConsumer<PlantMesh, PlantDice> grower) {
    /** A group of kinds. */
    public enum Family {
        TREE,
        ROCK;

        /** Returns the family of a command's word. */
        public static Optional<Family> named(String word) {
            return Stream.of(values())
                    .filter(family -> family.word().equals(word))
                    .findFirst();
        }

        /** Returns the word of commands. */
        public String word() {
            return this == TREE ? "tree" : "rock";
        }
    }

    /** Returns all kinds. */
    public static List<PlantKind> all() {
        return List.of(
                LeafyPlants.OAK,
                LeafyPlants.BIRCH,
                FirTree.KIND,
                LeafyPlants.CYPRESS,
                LeafyPlants.BUSH,
                GroundPlants.FERN,
                GroundPlants.GRASS,
                Rocks.BOULDER,
                Rocks.LEDGE);
    }

    /** Returns the kind with a name. */
    public static Optional<PlantKind> named(Family family, String word) {
        return all().stream()
                .filter(kind -> kind.family() == family && kind.word().equals(word))
                .findFirst();
    }

    /** Returns the names of a family's kinds, separated by commas. */
    public static String words(Family family) {
        return all().stream()
                .filter(kind -> kind.family() == family)
                .map(PlantKind::word)
                .collect(Collectors.joining(", "));
    }

    /** Returns the mesh of a seed: the same seed always gives the same mesh. */
    public Mesh grown(long seed) {
        PlantMesh mesh = new PlantMesh();
        grower.accept(mesh, new PlantDice(seed));
        return mesh.mesh(heightMetres);
    }
}
