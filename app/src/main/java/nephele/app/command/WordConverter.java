package nephele.app.command;

import java.util.EnumSet;
import java.util.Locale;
import java.util.stream.Collectors;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Parses one of a set of words, ignoring case; messages list them in lower case. */
record WordConverter<E extends Enum<E>>(EnumSet<E> words) implements ITypeConverter<E> {
    /** Accepts every constant of an enum. */
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
