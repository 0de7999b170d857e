/** Loads assets by name, safely: id grammar, header checks, size limits, picture decoding. */
package nephele.engine.asset;
