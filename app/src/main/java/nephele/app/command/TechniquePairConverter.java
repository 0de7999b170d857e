package nephele.app.command;

import nephele.engine.compare.TechniquePair;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Parses two techniques of clouds, such as `particles,volume`. */
final class TechniquePairConverter implements ITypeConverter<TechniquePair> {
    @Override
    public TechniquePair convert(String text) {
        try {
            return TechniquePair.parse(text);
        } catch (IllegalArgumentException wrong) {
            throw new TypeConversionException(wrong.getMessage());
        }
    }
}
