package nephele.lab.generate;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import nephele.lab.generate.PlantKind.Family;

/** All kinds of plants and rocks. */
public final class PlantKinds {
    public static final List<PlantKind> ALL = List.of(
            OakTree.KIND,
            BirchTree.KIND,
            FirTree.KIND,
            CypressTree.KIND,
            LeafyBush.KIND,
            Fern.KIND,
            GrassTuft.KIND,
            Boulder.KIND,
            LayeredRock.KIND);

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
