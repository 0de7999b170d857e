package nephele.lab.generate;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import nephele.lab.generate.PlantKind.Family;

/** All kinds of plants and rocks. */
public final class PlantKinds {
    public static final List<PlantKind> ALL = List.of(
            LeafyPlants.OAK,
            LeafyPlants.BIRCH,
            FirTree.KIND,
            LeafyPlants.CYPRESS,
            LeafyPlants.BUSH,
            GroundPlants.FERN,
            GroundPlants.GRASS,
            Rocks.BOULDER,
            Rocks.LEDGE);

    private PlantKinds() {}

    /** Returns the kind with a name. */
    public static Optional<PlantKind> named(Family family, String word) {
        return ALL.stream()
                .filter(kind -> kind.family() == family && kind.word().equals(word))
                .findFirst();
    }

    /** Returns the names of a family's kinds, separated by commas. */
    public static String words(Family family) {
        return ALL.stream()
                .filter(kind -> kind.family() == family)
                .map(PlantKind::word)
                .collect(Collectors.joining(", "));
    }
}
