package nephele.engine.named;

import java.util.List;
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
        return FILE.read(file, utf8);
    }
}
