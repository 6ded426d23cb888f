//! Lists, optional values and choices of values that have a table of keys.

use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;

use cdpr_model::reading::Keyword;
use schemars::generate::SchemaGenerator;
use schemars::{JsonSchema, Schema};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::table_schema::ReachableSize;
use crate::answers::Size;

/// Table of keys by which values are written.
pub(crate) trait Keys<T: ?Sized> {
    /// Writes the value under its keys.
    fn write<S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error>;
}

/// Makes tables of keys, which serde has given a way to write their values, known to [`Each`] and [`Maybe`].
macro_rules! tables {
    ($($keys:ty: $value:ty),+ $(,)?) => {$(
        impl $crate::keys::Keys<$value> for $keys {
            fn write<S: serde::Serializer>(value: &$value, serializer: S) -> Result<S::Ok, S::Error> {
                Self::serialize(value, serializer)
            }
        }
    )+};
}
pub(crate) use tables;

/// Table whose entries may stand among those of another.
pub(crate) trait Entries<T: ?Sized> {
    /// Writes the entries of the value.
    fn entries<M: SerializeMap>(value: &T, map: &mut M) -> Result<(), M::Error>;
}

/// Tables of keys with their schemas: `Keys of Value { field, field = "key", field by OtherKeys, field among OtherKeys, field.name(), field unless none }`.
/// A field, or what an index, a path or a method without arguments makes of it, stands under the field's name or the key that follows. It is written as it is, by another
/// table, or with the entries of another table among its own; `unless none` leaves out an optional value that is `None`. The documentation of a field describes its key.
/// The schema has the name of the table without `Keys`, or the one that follows: `Keys as "Name" of Value { … }`.
macro_rules! keys {
    ($($(#[doc = $about:expr])* $keys:ident $(as $title:literal)? of $value:ty {
        $($(#[doc = $doc:expr])* $field:ident $([$place:literal])? $(.$part:ident $(($($argument:tt)*))?)* $(unless $none:ident)? $(= $key:literal)? $(among $inner:ident)? $(by $table:ty)?),+ $(,)?
    })+) => {$(
        $(#[doc = $about])*
        pub(crate) struct $keys;

        impl $keys {
            pub(crate) fn serialize<S: serde::Serializer>(value: &$value, serializer: S) -> Result<S::Ok, S::Error> {
                let mut map = serializer.serialize_map(None)?;
                <Self as $crate::keys::adapters::Entries<$value>>::entries(value, &mut map)?;
                serde::ser::SerializeMap::end(map)
            }
        }

        impl $crate::keys::adapters::Entries<$value> for $keys {
            fn entries<M: serde::ser::SerializeMap>(value: &$value, map: &mut M) -> Result<(), M::Error> {
                $($crate::keys::adapters::entry!(
                    map, &value.$field$([$place])?$(.$part$(($($argument)*))?)*, stringify!($field), [$($none)?], [$($key)?], [$($table)?], [$($inner)?]
                );)+
                Ok(())
            }
        }

        impl schemars::JsonSchema for $keys {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                let titles: &[&'static str] = &[$($title,)? stringify!($keys)];
                $crate::keys::table_schema::table_name(titles[0])
            }

            fn schema_id() -> std::borrow::Cow<'static, str> {
                concat!(module_path!(), "::", stringify!($keys)).into()
            }

            fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                let mut table = $crate::keys::table_schema::TableSchema::new(&[$($about),*]);
                $($crate::keys::table_schema::entry_schema!(
                    generator, table, |value: &$value| $crate::keys::table_schema::type_of(&value.$field$([$place])?$(.$part$(($($argument)*))?)*),
                    stringify!($field), [$($none)?], [$($key)?], [$($table)?], [$($inner)?], [$($doc),*]
                );)+
                table.schema()
            }
        }

        $crate::keys::adapters::tables!($keys: $value);
    )+};
}
pub(crate) use keys;

/// Entry of a table that [`keys`] makes.
macro_rules! entry {
    ($map:ident, $value:expr, $name:expr, [none], $key:tt, $table:tt, $inner:tt) => {
        if $value.is_some() {
            $crate::keys::adapters::entry!($map, $value, $name, [], $key, $table, $inner);
        }
    };
    ($map:ident, $value:expr, $name:expr, [], [], [], [$inner:ident]) => {
        <$inner as $crate::keys::adapters::Entries<_>>::entries($value, $map)?
    };
    ($map:ident, $value:expr, $name:expr, [], [], $table:tt, []) => {
        $crate::keys::adapters::entry!($map, $value, $name, [], [$name], $table, [])
    };
    ($map:ident, $value:expr, $name:expr, [], [$key:expr], [], []) => {
        $map.serialize_entry($key, $value)?
    };
    ($map:ident, $value:expr, $name:expr, [], [$key:expr], [$table:ty], []) => {
        $map.serialize_entry($key, &$crate::keys::adapters::Written($value, std::marker::PhantomData::<$table>))?
    };
}
pub(crate) use entry;

/// A value with its table.
pub(crate) struct Written<'a, T: ?Sized, K>(pub(crate) &'a T, pub(crate) PhantomData<K>);

impl<T: ?Sized, K: Keys<T>> Serialize for Written<'_, T, K> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        K::write(self.0, serializer)
    }
}

/// List of values with one table.
pub(crate) struct Each<K>(PhantomData<K>);

impl<K> Each<K> {
    pub(crate) fn serialize<T, S: Serializer>(values: &[T], serializer: S) -> Result<S::Ok, S::Error>
    where
        K: Keys<T>,
    {
        serializer.collect_seq(values.iter().map(|value| Written(value, PhantomData::<K>)))
    }
}

impl<T, K: Keys<T>> Keys<Vec<T>> for Each<K> {
    fn write<S: Serializer>(value: &Vec<T>, serializer: S) -> Result<S::Ok, S::Error> {
        Self::serialize(value, serializer)
    }
}

/// Value with a table, or null.
pub(crate) struct Maybe<K>(PhantomData<K>);

impl<K> Maybe<K> {
    pub(crate) fn serialize<T, S: Serializer>(value: &Option<T>, serializer: S) -> Result<S::Ok, S::Error>
    where
        K: Keys<T>,
    {
        match value {
            Some(value) => serializer.serialize_some(&Written(value, PhantomData::<K>)),
            None => serializer.serialize_none(),
        }
    }
}

impl<T, K: Keys<T>> Keys<Option<T>> for Maybe<K> {
    fn write<S: Serializer>(value: &Option<T>, serializer: S) -> Result<S::Ok, S::Error> {
        Self::serialize(value, serializer)
    }
}

impl<T, K: Entries<T>> Entries<Option<T>> for K {
    fn entries<M: SerializeMap>(value: &Option<T>, map: &mut M) -> Result<(), M::Error> {
        value.as_ref().map_or(Ok(()), |value| K::entries(value, map))
    }
}

impl<T: Serialize> Entries<Size<T>> for ReachableSize {
    fn entries<M: SerializeMap>(size: &Size<T>, map: &mut M) -> Result<(), M::Error> {
        map.serialize_entry(&size.key(), &size.value)
    }
}

/// Name of a choice.
pub(crate) struct Word;

impl Word {
    pub(crate) fn serialize<T: Keyword, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(value.name())
    }
}

/// Text of a value that is shown by it.
pub(crate) struct Shown;

impl Shown {
    pub(crate) fn serialize<T: fmt::Display, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(value)
    }
}

/// Places as people count them: from 1.
pub(crate) struct FromOne;

impl Keys<usize> for FromOne {
    fn write<S: Serializer>(place: &usize, serializer: S) -> Result<S::Ok, S::Error> {
        (place + 1).serialize(serializer)
    }
}

impl<T, K: Keys<T>> Keys<Box<T>> for K {
    fn write<S: Serializer>(value: &Box<T>, serializer: S) -> Result<S::Ok, S::Error> {
        K::write(value, serializer)
    }
}

impl<T: ?Sized, K: Keys<T>> Keys<&T> for K {
    fn write<S: Serializer>(value: &&T, serializer: S) -> Result<S::Ok, S::Error> {
        K::write(*value, serializer)
    }
}

/// Takes the schema of an adapter from the type that it writes like.
macro_rules! schema_like {
    ([$($parameter:ident)?] $adapter:ty: $like:ty) => {
        impl$(<$parameter: JsonSchema>)? JsonSchema for $adapter {
            fn inline_schema() -> bool {
                <$like>::inline_schema()
            }

            fn schema_name() -> Cow<'static, str> {
                <$like>::schema_name()
            }

            fn schema_id() -> Cow<'static, str> {
                <$like>::schema_id()
            }

            fn json_schema(generator: &mut SchemaGenerator) -> Schema {
                <$like>::json_schema(generator)
            }
        }
    };
}
schema_like!([K] Each<K>: Vec<K>);
schema_like!([K] Maybe<K>: Option<K>);
schema_like!([] Word: String);
schema_like!([] Shown: String);
schema_like!([] FromOne: usize);
