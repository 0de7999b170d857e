package nephele.app.command;

import java.util.EnumSet;
import java.util.Locale;
import java.util.stream.Collectors;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** One of some words; messages list them as they are typed, in lower case. */
record WordConverter<E extends Enum<E>>(EnumSet<E> words) implements ITypeConverter<E> {
    /** Any of an enum's. */
    WordConverter(Class<E> type) {
        this(EnumSet.allOf(type));
    }

    @Override
    public E convert(String text) {
        for (E word : words) {
            if (word.name().equalsIgnoreCase(text)) {
                return word;
            }
        }
        var known =
                words.stream().map(word -> word.name().toLowerCase(Locale.ROOT)).collect(Collectors.joining(", "));
        throw new TypeConversionException("'" + text + "' is none of " + known);
    }
}
