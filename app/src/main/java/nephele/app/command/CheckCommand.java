package nephele.app.command;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.FileName;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.MessageText;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.json.AssetPlaces;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.PackageContent;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.rule.LevelRules;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.StoredLight;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import picocli.CommandLine.Parameters;

/** Prints the problems of levels, one a line; says if a level has no error, and whether its light is baked. */
@picocli.CommandLine.Command
final class CheckCommand implements Command {
    private static final int MOST_PLACES = 5;

    @Parameters(arity = "1..*", paramLabel = "LEVEL", description = "Level files, and packages (.zip) of the editor.")
    private List<String> levels;

    @Override
    public ExitCode run(Terminal terminal) {
        boolean isEachGood = true;
        for (var level : levels) {
            var checked = checked(level);
            var problems = checked.problems;
            lines(problems, level).forEach(terminal.out()::println);
            boolean isGood = problems.stream().noneMatch(Problem::isError);
            if (isGood) {
                terminal.out().println(level + ": good" + warnings(problems.size()));
                checked.light.ifPresent(stored -> terminal.out().println(level + ": " + stored.line(level)));
            }
            isEachGood &= isGood;
        }
        return isEachGood ? ExitCode.DONE : ExitCode.INPUT;
    }

    /** Returns a line for each error and for each kind of warning: equal warnings about several places are counted. */
    private static List<String> lines(List<Problem> problems, String level) {
        Map<String, List<Problem>> kinds = new LinkedHashMap<>();
        problems.forEach(problem -> kinds.computeIfAbsent(
                        problem.isError() ? problem.line(level) : problem.message(), kind -> new ArrayList<>())
                .add(problem));
        return kinds.values().stream()
                .map(equal -> equal.get(0).line(level) + MessageText.times(equal.size()) + others(equal))
                .toList();
    }

    /** Returns the places of all but the first of equal problems, as far as they can be told. */
    private static String others(List<Problem> equal) {
        String places =
                equal.stream().skip(1).limit(MOST_PLACES).map(Problem::path).collect(Collectors.joining(", "));
        return places.isEmpty() ? "" : ", also at " + places + (equal.size() > 1 + MOST_PLACES ? ", …" : "");
    }

    private static String warnings(int count) {
        return count == 0 ? "" : count == 1 ? ", with a warning" : ", with " + count + " warnings";
    }

    /** @param light empty for a level with errors, or without surfaces */
    private record Checked(List<Problem> problems, Optional<StoredLight> light) {
        static Checked of(Level level, AssetSource assets) {
            try {
                List<Problem> problems = LevelRules.check(level, assets);
                boolean isLit = LightRequirements.hasSurfaces(level)
                        && problems.stream().noneMatch(Problem::isError);
                return new Checked(
                        problems,
                        isLit ? Optional.of(LevelLight.stored(PlacedLevel.of(level, assets))) : Optional.empty());
            } catch (AssetException wrong) {
                // Files that are good one by one, but do not fit into memory together.
                String place = AssetPlaces.of(level).getOrDefault(wrong.assetId(), wrong.assetId());
                return new Checked(List.of(Problem.error(place, wrong.getMessage())), Optional.empty());
            }
        }
    }

    private static Checked checked(String file) {
        try {
            if (isFile(file)) {
                var path = Path.of(file);
                return Checked.of(LevelFile.read(path), LevelAssets.beside(path));
            }
            var opened = LevelFile.open(file);
            return Checked.of(opened.level(), opened.assets());
        } catch (LevelFormatException wrong) {
            return new Checked(wrong.problems(), Optional.empty());
        }
    }

    private static boolean isFile(String file) {
        return FileName.objection(file) == null && !PackageContent.isPackage(file) && Files.exists(Path.of(file));
    }
}
