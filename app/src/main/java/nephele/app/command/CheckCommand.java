package nephele.app.command;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
import nephele.engine.rule.LevelRules;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import picocli.CommandLine.Parameters;

/** Prints the problems of levels, one a line, and says so if a level has no error. */
@picocli.CommandLine.Command
final class CheckCommand implements Command {
    private static final int MOST_PLACES = 5;

    @Parameters(arity = "1..*", paramLabel = "LEVEL", description = "Level files, and packages (.zip) of the editor.")
    private List<String> levels;

    @Override
    public ExitCode run(Terminal terminal) {
        boolean isEachGood = true;
        for (var level : levels) {
            var problems = problems(level);
            lines(problems, level).forEach(terminal.out()::println);
            boolean isGood = problems.stream().noneMatch(Problem::isError);
            if (isGood) {
                terminal.out().println(level + ": good" + warnings(problems.size()));
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

    private static List<Problem> problems(String file) {
        try {
            if (isFile(file)) {
                var path = Path.of(file);
                return problems(LevelFile.read(path), LevelAssets.beside(path));
            }
            var opened = LevelFile.open(file);
            return problems(opened.level(), opened.assets());
        } catch (LevelFormatException wrong) {
            return wrong.problems();
        }
    }

    private static List<Problem> problems(Level level, AssetSource assets) {
        try {
            return LevelRules.check(level, assets);
        } catch (AssetException wrong) {
            // Files that are good one by one, but do not fit into memory together.
            String place = AssetPlaces.of(level).getOrDefault(wrong.assetId(), wrong.assetId());
            return List.of(Problem.error(place, wrong.getMessage()));
        }
    }

    private static boolean isFile(String file) {
        return FileName.objection(file) == null && !PackageContent.isPackage(file) && Files.exists(Path.of(file));
    }
}
