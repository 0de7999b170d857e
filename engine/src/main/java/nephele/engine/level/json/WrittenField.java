package nephele.engine.level.json;

import java.lang.reflect.Type;
import nephele.engine.level.NumberRange;
import nephele.engine.level.Written;

/**
 * A component of a {@link WrittenRecord}.
 *
 * @param type with type arguments, such as {@code List<Solid>}
 * @param written how a file has it
 * @param range of its numbers, or those of its entries; {@code null} if it holds none
 * @param absent its value in a file without the key; {@code null} also for a required component
 * @param prototype its value in a record that an editor makes; {@code null} if the declaration gives none
 */
public record WrittenField(
        String name, Type type, Written written, NumberRange range, Object absent, Object prototype) {}
