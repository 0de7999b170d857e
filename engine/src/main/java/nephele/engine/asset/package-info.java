/** Names to bytes, safely: id grammar, header checks, size limits, decoding. */
package nephele.engine.asset;
