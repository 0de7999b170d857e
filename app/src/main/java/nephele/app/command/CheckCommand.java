package nephele.app.command;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.FileName;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.sim.WorldRules;
import nephele.engine.terminal.ExitCode;
import nephele.engine.terminal.Terminal;
import picocli.CommandLine.Parameters;

/** Prints the problems of levels, one a line, and says so if a level has no error. */
@picocli.CommandLine.Command
final class CheckCommand implements Command {
    @Parameters(arity = "1..*", paramLabel = "LEVEL", description = "Level files.")
    private List<String> levels;

    @Override
    public ExitCode run(Terminal terminal) {
        boolean isEachGood = true;
        for (var level : levels) {
            var problems = problems(level);
            problems.forEach(problem -> terminal.out().println(problem.line(level)));
            boolean isGood = problems.stream().noneMatch(Problem::isError);
            if (isGood) {
                terminal.out().println(level + ": good" + warnings(problems.size()));
            }
            isEachGood &= isGood;
        }
        return isEachGood ? ExitCode.DONE : ExitCode.INPUT;
    }

    private static String warnings(int count) {
        return count == 0 ? "" : count == 1 ? ", with a warning" : ", with " + count + " warnings";
    }

    private static List<Problem> problems(String file) {
        try {
            if (isFile(file)) {
                var path = Path.of(file);
                return WorldRules.check(LevelFile.read(path), LevelAssets.beside(path));
            }
            var opened = LevelFile.open(file);
            return WorldRules.check(opened.level(), opened.assets());
        } catch (LevelFormatException wrong) {
            return wrong.problems();
        } catch (AssetException wrong) {
            return List.of(Problem.error("$", wrong.getMessage()));
        }
    }

    private static boolean isFile(String file) {
        return FileName.objection(file) == null && Files.exists(Path.of(file));
    }
}
