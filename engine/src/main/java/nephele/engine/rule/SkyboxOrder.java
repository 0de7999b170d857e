package nephele.engine.rule;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import nephele.engine.level.Problem;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.SkyboxSquare;
import nephele.engine.level.json.WordFormats;

/** The number and order of the files of a skybox. */
final class SkyboxOrder {
    private static final String PATH = "environment.sky.files";

    private SkyboxOrder() {}

    /** Returns an error for another number than the layout's, or a warning if the names tell another order. */
    static Optional<Problem> objection(Sky.Skybox skybox) {
        int wanted = SkyboxSquare.files(skybox.layout());
        int listed = skybox.files().size();
        String layout = "layout " + WordFormats.Choice.word(skybox.layout());
        List<String> names = SkyboxSquare.of(skybox.layout()).stream()
                .map(SkyboxSquare::name)
                .toList();
        if (listed != wanted) {
            String order = wanted == 1 ? "" : "; list them in the order " + String.join(", ", names);
            return Optional.of(Problem.error(PATH, layout + " needs " + wanted + " files, not " + listed + order));
        }
        List<String> ends =
                skybox.files().stream().map(file -> endOf(file, names)).toList();
        boolean isAnotherOrder = !ends.equals(names) && new HashSet<>(ends).equals(new HashSet<>(names));
        return isAnotherOrder
                ? Optional.of(Problem.warning(
                        PATH,
                        "the files' names end in " + String.join(", ", ends) + "; " + layout + " reads them as "
                                + String.join(", ", names)))
                : Optional.empty();
    }

    /** Returns the square's name with which a file's name ends before its extension, empty if there is none. */
    private static String endOf(String file, List<String> names) {
        String stem = file.replaceFirst("\\.[^./]*$", "");
        return names.stream().filter(stem::endsWith).findFirst().orElse("");
    }
}
