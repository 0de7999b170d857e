package nephele.lab.bake;

import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Hash64;
import nephele.host.named.OpenedLevel;

/** A hash of a level's text and of the content of the assets that it names. */
public final class LevelHash {
    private static final Pattern STRING = Pattern.compile("\"([^\"\\\\]+)\"");

    private LevelHash() {}

    /**
     * Returns a hash that is equal for equal levels with equal assets. An asset that is missing or not a file counts as
     * empty.
     */
    public static String key(OpenedLevel opened) {
        Level level = opened.level();
        long hash = Hash64.of(LevelJson.write(level));
        // A level may have a hundred thousand solids, and solids name only materials, never assets.
        String naming = LevelJson.write(level.with(level.materials(), List.of()));
        var ids = STRING.matcher(naming)
                .results()
                .map((MatchResult string) -> string.group(1))
                .filter(id ->
                        AssetId.rejectionReason(id) == null && opened.assets().exists(id))
                .distinct()
                .toList();
        for (String id : ids) {
            hash = Hash64.combine(hash, Hash64.of(content(id, opened.assets())));
        }
        return Long.toHexString(hash);
    }

    private static byte[] content(String id, AssetSource assets) {
        try {
            return assets.bytes(id);
        } catch (AssetException unreadable) {
            return new byte[0];
        }
    }
}
