package nephele.engine.named;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Problem;
import nephele.engine.level.TextKind;
import nephele.engine.level.Written;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.RecordFile;

/**
 * The order of the game's levels: the content of {@code levels/campaign.json}.
 *
 * @param levels files beside the campaign's
 */
public record Campaign(@Written(required = true, most = 1000, text = TextKind.ASSET) List<String> levels) {
    private static final RecordFile<Campaign> FILE = RecordFile.of("campaign", 1, Campaign.class);

    /**
     * Reads a campaign.
     *
     * @param file its name in messages
     * @throws LevelFormatException with all problems
     */
    static Campaign read(String file, byte[] utf8) throws LevelFormatException {
        Campaign campaign = FILE.read(file, utf8);
        List<Problem> twice = campaign.twice();
        if (!twice.isEmpty()) {
            throw new LevelFormatException(file, twice);
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
}
