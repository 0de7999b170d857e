package nephele.host.named;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Language;
import nephele.engine.level.Problem;
import nephele.engine.level.TextKind;
import nephele.engine.level.Written;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.RecordFile;

/**
 * The order of the game's levels, and what players call them: the content of {@code levels/campaign.json}.
 *
 * @param levels files beside the campaign's
 * @param titles of levels, by file and language; a level without one is called after its file
 */
public record Campaign(
        @Written(required = true, most = 1000, text = TextKind.ASSET) List<String> levels,
        @Written Map<String, Map<Language, String>> titles) {
    private static final RecordFile<Campaign> FILE = RecordFile.of("campaign", 1, Campaign.class);

    /**
     * Reads a campaign.
     *
     * @param file its name in messages
     * @throws LevelFormatException with all problems
     */
    static Campaign read(String file, byte[] utf8) throws LevelFormatException {
        Campaign campaign = FILE.read(file, utf8);
        List<Problem> problems = campaign.twice();
        problems.addAll(campaign.strayTitles());
        if (!problems.isEmpty()) {
            throw new LevelFormatException(file, problems);
        }
        return campaign;
    }

    /** Returns an error for each level that is there already: the next one after it would be that after the first. */
    private List<Problem> twice() {
        List<Problem> twice = new ArrayList<>();
        for (int i = 0; i < levels.size(); i++) {
            int first = levels.indexOf(levels.get(i));
            if (first < i) {
                twice.add(Problem.error(
                        "levels[" + i + "]",
                        "'" + levels.get(i) + "' is already levels[" + first
                                + "]: a level is played once, delete one"));
            }
        }
        return twice;
    }

    /** Returns an error for each title of a level that is not in the list: a file that was renamed, most likely. */
    private List<Problem> strayTitles() {
        return titles.keySet().stream()
                .filter(level -> !levels.contains(level))
                .map(level -> Problem.error(
                        "titles." + level, "there is no such entry in levels: add it there, or delete this title"))
                .toList();
    }
}
