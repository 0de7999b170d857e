package nephele.app.settings;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.util.function.Consumer;

/**
 * The levels that a player has finished, and the actions that the player has learned; immutable. Broken entries count as
 * unfinished and stay in the file.
 */
public final class Progress {
    public static final Progress NONE = new Progress(new JsonObject());

    private static final String LEVELS = "levels";
    private static final String FINISHED = "finished";
    private static final String BEST_TICKS = "bestTicks";
    private static final String PORTALS = "portals";
    private static final String HINTS = "hints";
    private static final String LEARNED = "learned";

    private final JsonObject members;

    private Progress(JsonObject members) {
        this.members = members;
    }

    /**
     * Returns the progress of a file's members.
     *
     * @param report receives a line for each broken entry
     */
    public static Progress of(JsonObject members, Consumer<String> report) {
        JsonElement levels = members.get(LEVELS);
        if (levels != null && !levels.isJsonObject()) {
            report.accept(LEVELS + ": must be an object with an entry for each level; it is left as it is");
        } else if (levels != null) {
            levels.getAsJsonObject().entrySet().forEach(level -> {
                if (!isGood(level.getValue())) {
                    report.accept(
                            LEVELS + "." + level.getKey() + ": must be {\"finished\": true or false, \"bestTicks\":"
                                    + " a whole number, \"portals\": a whole number}; it is left as it is");
                }
            });
        }
        if (members.has(LEARNED) && !members.get(LEARNED).isJsonArray()) {
            report.accept(LEARNED + ": must be a list of actions; it is written anew");
        }
        return new Progress(members.deepCopy());
    }

    /** Returns true if an action was done once, so that its key needs no naming. */
    public boolean hasLearned(String action) {
        return members.get(LEARNED) instanceof JsonArray all && all.contains(new JsonPrimitive(action));
    }

    /** Returns the progress after an action was done for the first time. */
    public Progress withLearned(String action) {
        if (hasLearned(action)) {
            return this;
        }
        JsonObject changed = members.deepCopy();
        JsonArray all = changed.get(LEARNED) instanceof JsonArray before ? before : new JsonArray();
        all.add(action);
        changed.add(LEARNED, all);
        return new Progress(changed);
    }

    private static boolean isGood(JsonElement level) {
        return level.isJsonObject()
                && level.getAsJsonObject().get(FINISHED) instanceof JsonPrimitive finished
                && finished.isBoolean()
                && isCount(level.getAsJsonObject().get(BEST_TICKS))
                && isCount(level.getAsJsonObject().get(PORTALS))
                && (!level.getAsJsonObject().has(HINTS)
                        || isCount(level.getAsJsonObject().get(HINTS)));
    }

    private static boolean isCount(JsonElement value) {
        if (!(value instanceof JsonPrimitive number) || !number.isNumber()) {
            return false;
        }
        double count = number.getAsDouble();
        return count >= 0 && count <= 1L << 53 && count == Math.rint(count);
    }

    /** Returns true if a level has been finished. */
    public boolean isFinished(String file) {
        JsonObject level = level(file);
        return level != null && level.get(FINISHED).getAsBoolean();
    }

    /** Returns the least ticks in which a level was finished; 0 if it was not. */
    public long bestTicks(String file) {
        return isFinished(file) ? level(file).get(BEST_TICKS).getAsLong() : 0;
    }

    /** Returns the portals shot in the best run of a level; 0 if it was not finished. */
    public long portals(String file) {
        return isFinished(file) ? level(file).get(PORTALS).getAsLong() : 0;
    }

    /** Returns the hints taken in the best run of a level; 0 if it was not finished. */
    public long hints(String file) {
        return isFinished(file) && level(file).has(HINTS)
                ? level(file).get(HINTS).getAsLong()
                : 0;
    }

    private JsonObject level(String file) {
        JsonElement levels = members.get(LEVELS);
        JsonElement level = levels != null && levels.isJsonObject()
                ? levels.getAsJsonObject().get(file)
                : null;
        return level != null && isGood(level) ? level.getAsJsonObject() : null;
    }

    /** Returns the progress after a level was finished; a slower run than the best changes nothing. */
    public Progress withFinished(String file, long ticks, long portals, long hints) {
        if (isFinished(file) && bestTicks(file) <= ticks) {
            return this;
        }
        JsonObject changed = members.deepCopy();
        JsonElement levels = changed.get(LEVELS);
        JsonObject all = levels != null && levels.isJsonObject() ? levels.getAsJsonObject() : new JsonObject();
        JsonElement before = all.get(file);
        JsonObject level = before != null && before.isJsonObject() ? before.getAsJsonObject() : new JsonObject();
        level.addProperty(FINISHED, true);
        level.addProperty(BEST_TICKS, ticks);
        level.addProperty(PORTALS, portals);
        level.addProperty(HINTS, hints);
        all.add(file, level);
        changed.add(LEVELS, all);
        return new Progress(changed);
    }

    /** Returns the members of the file. */
    public JsonObject members() {
        return members.deepCopy();
    }
}
