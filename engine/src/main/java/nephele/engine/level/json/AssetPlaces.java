package nephele.engine.level.json;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.TextKind;

/** Where a level names files: every component of kind {@link TextKind#ASSET}. */
public final class AssetPlaces {
    private final Map<String, String> places = new LinkedHashMap<>();

    private AssetPlaces() {}

    /** Returns the names in the order of the file, each with the path of its first place. */
    public static Map<String, String> of(Level level) {
        AssetPlaces found = new AssetPlaces();
        found.members(level, "");
        return found.places;
    }

    private void members(Record owner, String path) {
        WrittenRecord record = WrittenRecord.of(owner.getClass());
        for (int i = 0; i < record.fields().size(); i++) {
            WrittenField field = record.fields().get(i);
            String name = path.isEmpty() ? field.name() : path + "." + field.name();
            boolean isAsset = field.written().text() == TextKind.ASSET;
            value(record.value(owner, i), isAsset, field.written().beside() ? path : name);
        }
    }

    private void value(Object value, boolean isAsset, String path) {
        if (value instanceof String name && isAsset) {
            places.putIfAbsent(name, path);
        } else if (value instanceof List<?> list) {
            for (int i = 0; i < list.size(); i++) {
                value(list.get(i), isAsset, path + "[" + i + "]");
            }
        } else if (value instanceof Map<?, ?> table) {
            table.forEach((key, entry) -> value(entry, isAsset, path + "." + key));
        } else if (value instanceof Record record
                && !(record instanceof Exposure)
                && record.getClass().getPackageName().equals(Level.class.getPackageName())) {
            members(record, path);
        }
    }
}
